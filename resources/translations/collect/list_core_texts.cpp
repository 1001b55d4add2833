#include "core/registration/registration.h"
#include "resources/translations/collect/scan_sentences.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <ranges>
#include <sstream>
#include <vector>

using namespace angiopose;

// Writes the C++ list of all that core and io can say to the user, for lupdate to collect and the window to translate:
// what the tables hold, and the sentences found in the sources. The layers themselves know no translations.
// Usage: list_core_texts OUTPUT.cpp SOURCE…

namespace {

using Texts = std::set<std::string>;

std::string contentOf(const std::filesystem::path& path)
{
    std::ostringstream content;
    content << std::ifstream(path).rdbuf();
    return content.str();
}

void addTables(Texts& texts)
{
    for (const core::OptionField& field : core::optionFields()) {
        texts.insert({std::string(field.label), std::string(field.help)});
        for (std::string choice : field.choices | std::views::transform([](auto key) { return std::string(key); })) {
            std::ranges::replace(choice, '_', ' ');   // as the window shows it
            texts.insert(choice);
        }
    }
    for (const core::MethodInfo& info : core::methodInfos()) {
        texts.emplace(info.summary);
    }
    for (const auto reason : {core::StopReason::Converged, core::StopReason::IterationLimit,
                              core::StopReason::NoImprovement, core::StopReason::StoppedByUser}) {
        texts.emplace(core::toText(reason));
    }
}

/// Single words that the layers hand over as they are: stages of a run, origins of a value, what tells patients apart.
void addWords(Texts& texts)
{
    texts.insert({"search", "refine", "settle", "rotation", "auxiliary", "full", "affine", "header", "derived", "user",
                  "assumed", "missing", "identity hidden", "number", "name", "birth date", "before: at the start pose",
                  "after: at this pose"});
}

/// A placeholder must be told from the rest by at least a few letters.
bool isTellable(const std::string& text)
{
    return text.find('%') == std::string::npos ||
           std::ranges::count_if(text, [](unsigned char c) { return std::isalpha(c) != 0; }) >= 3;
}

std::string literal(const std::string& text)
{
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            quoted += '\\';
        }
        quoted += c == '\n' ? "\\n" : std::string(1, c);
    }
    return quoted + '"';
}

std::string listingOf(const Texts& texts)
{
    std::string listing =
        "// Made by list_core_texts.\n#include \"ui/words/core_texts.h\"\n\n#include "
        "<QtGlobal>\n\n#include <array>\n\nnamespace angiopose::ui {\n\nstd::span<const char* const> "
        "coreTexts()\n{\n    static constexpr std::array texts{\n";
    for (const std::string& text : texts) {
        if (isTellable(text)) {
            listing += "        QT_TRANSLATE_NOOP(\"core\", " + literal(text) + "),\n";
        }
    }
    return listing + "    };\n    return texts;\n}\n\n}   // namespace angiopose::ui\n";
}

}   // namespace

int main(int argc, char** argv)
{
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    if (arguments.size() < 2) {
        std::cerr << "Usage: list_core_texts OUTPUT.cpp SOURCE…\n";
        return 2;
    }
    Texts texts;
    addTables(texts);
    addWords(texts);
    for (auto source = arguments.begin() + 1; source != arguments.end(); ++source) {
        texts.merge(core_texts::scanSentences(contentOf(*source)));
    }
    const std::string listing = listingOf(texts);
    if (contentOf(arguments.front()) != listing) {
        std::ofstream(arguments.front()) << listing;   // an unchanged list wakes no compiler
    }
    return 0;
}
