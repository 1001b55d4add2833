#include "app/messages/catalog.h"
#include "core/messages/catalog.h"
#include "core/registration/options/option_fields.h"
#include "core/registration/registration.h"
#include "io/messages/catalog.h"

#include <algorithm>
#include <fstream>
#include <iostream>
#include <set>
#include <string>

using namespace angiopose;

// Writes what the layers can say to the user as C++ that lupdate understands: the catalogs' sentences by their ids,
// and the words of core's tables. The layers themselves know no translations. Usage: list_messages OUTPUT.cpp

namespace {

std::string literal(std::string_view text)
{
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            quoted += '\\';
        }
        quoted += c;
    }
    return quoted + '"';
}

std::string sentences()
{
    std::string list;
    for (const auto& catalog : {core::messageCatalog(), io::messageCatalog(), app::messageCatalog()}) {
        for (const core::MessageEntry* entry : catalog) {
            list +=
                "    QT_TRANSLATE_NOOP3(\"messages\", " + literal(entry->english) + ", " + literal(entry->id) + "),\n";
        }
    }
    return list;
}

std::string terms()
{
    std::set<std::string> all{"search", "refine", "settle", "rotation", "auxiliary",
                              "full",   "affine", "joint",  "bending"};   // stages
    for (const core::OptionField& field : core::optionFields()) {
        all.insert({std::string(field.label), std::string(field.help)});
        for (const std::string_view key : core::namesOf(field)) {
            std::string choice(key);
            std::ranges::replace(choice, '_', ' ');   // as the window shows it
            all.insert(choice);
        }
    }
    for (const core::MethodInfo& info : core::methodInfos()) {
        all.emplace(info.summary);
    }
    for (const auto reason : {core::StopReason::Converged, core::StopReason::IterationLimit,
                              core::StopReason::NoImprovement, core::StopReason::StoppedByUser}) {
        all.emplace(core::toText(reason));
    }
    std::string list;
    for (const std::string& term : all) {
        list += "    QT_TRANSLATE_NOOP(\"core\", " + literal(term) + "),\n";
    }
    return list;
}

}   // namespace

int main(int argc, char** argv)
{
    if (argc != 2) {
        std::cerr << "Usage: list_messages OUTPUT.cpp\n";
        return 2;
    }
    std::ofstream(argv[1]) << "// Made by list_messages.\n" << terms() << sentences();
    return 0;
}
