// SPDX-License-Identifier: Apache-2.0
// Each is drawn in a square of 24 by 24, y downward, by a few filled shapes and lines of one breadth: silhouettes that
// are told apart at the size of a letter.
#include "render/pictogram.hpp"

#include <algorithm>
#include <initializer_list>
#include <numbers>
#include <utility>

#include "render/cairo_drawing.hpp"

namespace quadrat::render {
namespace {

constexpr double kSquare = 24;
constexpr double kLine = 2;

class Sketch {
  public:
    explicit Sketch(cairo_t* pen) : pen_(pen) {
        cairo_set_line_width(pen_, kLine);
        cairo_set_line_cap(pen_, CAIRO_LINE_CAP_ROUND);
        cairo_set_line_join(pen_, CAIRO_LINE_JOIN_ROUND);
        cairo_set_source_rgb(pen_, 1, 1, 1);
    }

    void disc(double x, double y, double radius) const {
        circle(x, y, radius);
        cairo_fill(pen_);
    }
    void ring(double x, double y, double radius) const {
        circle(x, y, radius);
        cairo_stroke(pen_);
    }
    void area(std::initializer_list<std::pair<double, double>> corners) const {
        trace(corners);
        cairo_close_path(pen_);
        cairo_fill_preserve(pen_);
        cairo_stroke(pen_);
    }
    void line(std::initializer_list<std::pair<double, double>> corners) const {
        trace(corners);
        cairo_stroke(pen_);
    }
    void box(double x, double y, double width, double height) const {
        cairo_rectangle(pen_, x, y, width, height);
        cairo_stroke(pen_);
    }
    // From one end to the other, bulging to the left of the way.
    void leaf(double x, double y, double to_x, double to_y, double bulge) const {
        const double dx = to_x - x, dy = to_y - y;
        const double middle_x = (x + to_x) / 2, middle_y = (y + to_y) / 2;
        cairo_new_path(pen_);
        cairo_move_to(pen_, x, y);
        for (const double side : {1.0, -1.0}) {
            const double bend_x = middle_x + side * bulge * dy, bend_y = middle_y - side * bulge * dx;
            cairo_curve_to(pen_, bend_x, bend_y, bend_x, bend_y, side > 0 ? to_x : x, side > 0 ? to_y : y);
        }
        cairo_fill(pen_);
    }
    // What is drawn until the next call is taken away instead.
    void erase(bool is_erasing) const {
        cairo_set_operator(pen_, is_erasing ? CAIRO_OPERATOR_DEST_OUT : CAIRO_OPERATOR_OVER);
    }
    void ellipse_ring(double x, double y, double half_width, double half_height) const {
        cairo_save(pen_);
        cairo_translate(pen_, x, y);
        cairo_scale(pen_, half_width, half_height);
        circle(0, 0, 1);
        cairo_restore(pen_);
        cairo_stroke(pen_);
    }

  private:
    void circle(double x, double y, double radius) const {
        cairo_new_path(pen_);
        cairo_arc(pen_, x, y, radius, 0, 2 * std::numbers::pi);
    }
    void trace(std::initializer_list<std::pair<double, double>> corners) const {
        cairo_new_path(pen_);
        for (const auto& [x, y] : corners) cairo_line_to(pen_, x, y);
    }
    cairo_t* pen_;
};

void cloud(const Sketch& at) {
    at.disc(8, 17, 4);
    at.disc(13, 14, 5);
    at.disc(18, 17, 4);
    at.area({{8, 20}, {18, 20}, {18, 18}, {8, 18}});
}

// What is asked about, and what is done.
void draw_subject(Pictogram which, const Sketch& at) {
    switch (which) {
        case Pictogram::Tree:
            at.disc(12, 7, 5);
            at.disc(7.5, 11.5, 4.5);
            at.disc(16.5, 11.5, 4.5);
            at.area({{11.2, 12}, {12.8, 12}, {13.2, 21.5}, {10.8, 21.5}});
            return;
        case Pictogram::Land:
            at.area({{3, 19.5}, {10, 5.5}, {17, 19.5}});
            at.area({{13, 19.5}, {17.5, 11.5}, {21.5, 19.5}});
            return;
        case Pictogram::Sky:
            at.disc(16.5, 8, 4);
            for (const auto& [x, y] : {std::pair{16.5, 1.5}, {11.9, 3.4}, {21.1, 3.4}, {23, 8}}) {
                const double dx = (x - 16.5) / 6.5, dy = (y - 8) / 6.5;
                at.line({{16.5 + 5.6 * dx, 8 + 5.6 * dy}, {x, y}});
            }
            at.erase(true);
            at.disc(13, 14, 6.4);
            at.disc(18, 17, 5.4);
            at.erase(false);
            cloud(at);
            return;
        case Pictogram::Press:
            at.ring(11.5, 7.5, 5);
            at.erase(true);
            at.area({{9.9, 7}, {13.1, 7}, {13.1, 15}, {9.9, 15}});
            at.erase(false);
            at.line({{11.5, 7.5}, {11.5, 15}});
            at.disc(11.5, 7.5, 1.5);
            at.area({{11, 13.5}, {16.5, 14.5}, {18, 16}, {16.5, 21}, {12, 21}, {7.5, 16.5}, {8.5, 15.5}, {11, 17}});
            return;
        case Pictogram::Sprout:
            at.line({{12, 21.5}, {12, 10}});
            at.leaf(12, 14, 3, 6.5, 0.42);
            at.leaf(12, 11.5, 21, 3.5, 0.42);
            at.line({{6, 21.5}, {18, 21.5}});
            return;
        default:
            return;
    }
}

// What the exhibit says of itself.
void draw_notice(Pictogram which, const Sketch& at) {
    switch (which) {
        case Pictogram::Clock:
            at.ring(12, 12, 9);
            at.line({{12, 6.5}, {12, 12}, {16, 14.5}});
            return;
        case Pictogram::Frame:
            at.box(2.5, 4, 19, 16);
            at.area({{6, 16.5}, {10, 9.5}, {14, 16.5}});
            at.area({{13, 16.5}, {15.8, 12.5}, {18.2, 16.5}});
            at.disc(17, 8.3, 1.6);
            return;
        case Pictogram::Speech:
            at.area({{4, 5}, {20, 5}, {20, 15}, {11, 15}, {7, 19.5}, {7, 15}, {4, 15}});
            at.erase(true);
            for (const double x : {8.0, 12.0, 16.0}) at.disc(x, 10, 1.3);
            at.erase(false);
            return;
        case Pictogram::Language:
            at.ring(12, 12, 9);
            at.ellipse_ring(12, 12, 4, 9);
            at.line({{3, 12}, {21, 12}});
            at.line({{4.6, 7}, {19.4, 7}});
            at.line({{4.6, 17}, {19.4, 17}});
            return;
        case Pictogram::Slider:
            at.line({{3, 8}, {21, 8}});
            at.line({{3, 16}, {21, 16}});
            at.disc(9, 8, 3.2);
            at.disc(15.5, 16, 3.2);
            return;
        case Pictogram::House:
            at.area({{12, 4}, {3.5, 11.5}, {20.5, 11.5}});
            at.area({{6, 12}, {18, 12}, {18, 20.5}, {6, 20.5}});
            at.erase(true);
            at.area({{11, 16}, {13, 16}, {13, 20.5}, {11, 20.5}});
            at.erase(false);
            return;
        case Pictogram::Moon:
            at.disc(11.5, 12, 9);
            at.erase(true);
            at.disc(16, 9, 7.6);
            at.erase(false);
            return;
        default:
            return;
    }
}

// Who plays, and what came of what.
void draw_company(Pictogram which, const Sketch& at) {
    switch (which) {
        case Pictogram::Family:
            at.area({{9, 3.5}, {15, 3.5}, {15, 8}, {9, 8}});
            at.area({{3, 16}, {9, 16}, {9, 20.5}, {3, 20.5}});
            at.area({{15, 16}, {21, 16}, {21, 20.5}, {15, 20.5}});
            at.line({{12, 9}, {12, 12}});
            at.line({{6, 15}, {6, 12}, {18, 12}, {18, 15}});
            return;
        case Pictogram::Person:
            at.disc(12, 7, 4.5);
            at.disc(8.5, 16.5, 4);
            at.disc(15.5, 16.5, 4);
            at.area({{8.5, 14}, {15.5, 14}, {18.5, 17}, {18.5, 21}, {5.5, 21}, {5.5, 17}});
            return;
        default:
            return;
    }
}

// What is done with fewer buttons, and at the end.
void draw_deed(Pictogram which, const Sketch& at) {
    switch (which) {
        case Pictogram::Back:
            at.area({{4, 12}, {11, 5.5}, {11, 18.5}});
            at.area({{11, 11}, {20, 11}, {20, 13}, {11, 13}});
            return;
        case Pictogram::Mark:
            for (const double x : {3.0, 21.0})
                for (const double y : {4.0, 20.0}) {
                    const double in_x = x < 12 ? 5 : -5, in_y = y < 12 ? 5 : -5;
                    at.line({{x + in_x, y}, {x, y}, {x, y + in_y}});
                }
            at.area({{9, 10}, {15, 10}, {15, 14}, {9, 14}});
            return;
        case Pictogram::Sound:
            at.area({{3, 9.5}, {7, 9.5}, {11.5, 5.5}, {11.5, 18.5}, {7, 14.5}, {3, 14.5}});
            at.line({{15.5, 9}, {16.6, 12}, {15.5, 15}});
            at.line({{18.8, 6.5}, {20.8, 12}, {18.8, 17.5}});
            return;
        case Pictogram::Print:
            at.area({{3.5, 10}, {20.5, 10}, {20.5, 16}, {3.5, 16}});
            at.line({{7, 9}, {7, 3.5}, {17, 3.5}, {17, 9}});
            at.erase(true);
            at.area({{8, 14.5}, {16, 14.5}, {16, 20}, {8, 20}});
            at.erase(false);
            at.line({{7, 14}, {7, 20.5}, {17, 20.5}, {17, 14}, {7, 14}});
            return;
        case Pictogram::Done:
            at.area({{4, 12.5}, {6, 10.5}, {9.8, 14.6}, {18.5, 5}, {20.5, 7}, {9.8, 18.8}});
            return;
        default:
            return;
    }
}

}  // namespace

mesh::Image pictogram(Pictogram which, int size_px) {
    const int size = std::max(size_px, 8);
    const float halo_px = 0.05F * static_cast<float>(size);
    const Surface surface = new_surface(size, size);
    const Pen pen{cairo_create(surface.get())};
    const double inner = size - 4.4 * static_cast<double>(halo_px);
    cairo_translate(pen.get(), (size - inner) / 2, (size - inner) / 2);
    cairo_scale(pen.get(), inner / kSquare, inner / kSquare);
    draw_subject(which, Sketch(pen.get()));
    draw_notice(which, Sketch(pen.get()));
    draw_company(which, Sketch(pen.get()));
    draw_deed(which, Sketch(pen.get()));
    mesh::Image image = image_of(surface.get());
    put_halo_under(image, halo_px);
    return image;
}

}  // namespace quadrat::render
