// SPDX-License-Identifier: Apache-2.0
#include "kiosk/command_line.hpp"

int main(int argc, char** argv) { return quadrat::kiosk::run_command_line(argc, argv); }
