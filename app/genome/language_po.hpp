// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <string_view>

namespace quadrat::genome {

// A language as translators' tools read it: gettext's PO, an entry a text, its key as the context ("prompts/attract",
// "words/wet/0" for the word's low end), the English text as what is translated. No text of ours holds a number that
// a noun would have to agree with: there are no plural forms.

// What a language has, to go on with; for a code that is not spoken, what there is to translate.
std::string po_of(std::string_view code);

// The same as genome/languages/*.json has it. What is not translated yet is left out: it is spoken in English. Throws
// InputError "SOURCE:LINE: …" for bytes that are no UTF-8, for what is no PO, for a key that there is not, and for one
// that comes twice.
std::string json_of_po(std::string_view po, std::string_view source);

}  // namespace quadrat::genome
