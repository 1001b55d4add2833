#include "io/sharing/redaction.h"

#include "io/sharing/vocabulary.h"
#include "io/support/system/current_process.h"
#include "io/support/system/machine_info.h"

#include <algorithm>
#include <array>

namespace angiopose::io {
namespace {

constexpr std::size_t minWordBytes = 3;
constexpr std::size_t minSubstringBytes = 6;   // minimum length of identifiers that are removed even inside other words
constexpr char hidden = '\x01';   // marks removed identifiers until all have been found

/// Technical words that are common in descriptions and file names.
constexpr std::array<std::string_view, 64> technicalWords{
    "angio",   "angiogram", "angiography", "angiopose", "arteries", "artery",  "artefact", "brain",
    "case",    "cases",     "contrast",    "coronary",  "curves",   "data",    "dicom",    "edited",
    "file",    "files",     "frame",       "frames",    "head",     "heart",   "home",     "image",
    "images",  "left",      "main",        "mask",      "none",     "off",     "options",  "phantom",
    "pose",    "result",    "right",       "root",      "run",      "runs",    "sample",   "scan",
    "series",  "settings",  "slices",      "study",     "test",     "tree",    "true",     "vessel",
    "vessels", "view",      "views",       "work",      "with",     "without", "cli",      "the",
    "and",     "for",       "from",        "mm",        "not",      "per",     "was",      "are"};

constexpr std::array<std::string_view, 34> fileEndings{
    ".angiopose", ".bmp", ".csv", ".dcm", ".gif",  ".gz",   ".h5",  ".html", ".ima", ".jpeg", ".jpg", ".json",
    ".log",       ".mha", ".mhd", ".mp4", ".nii",  ".nrrd", ".obj", ".pdf",  ".ply", ".png",  ".raw", ".stl",
    ".svg",       ".swc", ".tfm", ".tif", ".tiff", ".txt",  ".vtk", ".vtp",  ".xml", ".zip"};

bool isTechnicalWord(std::string_view folded)
{
    const auto isEnding = [folded](std::string_view ending) { return ending.substr(1) == folded; };
    return std::ranges::find(technicalWords, folded) != technicalWords.end() ||
           std::ranges::any_of(fileEndings, isEnding);
}

bool isBound(std::string_view text, std::size_t at, std::size_t size)
{
    return (at == 0 || !isWordCharacter(text[at - 1])) &&
           (at + size >= text.size() || !isWordCharacter(text[at + size]));
}

void hide(const std::string& identifier, std::string& text, std::string& folded)
{
    for (std::size_t at = 0; (at = folded.find(identifier, at)) != std::string::npos;) {
        if (identifier.size() < minSubstringBytes && !isBound(folded, at, identifier.size())) {
            at += identifier.size();
            continue;
        }
        text.replace(at, identifier.size(), 1, hidden);
        folded.replace(at, identifier.size(), 1, hidden);
        ++at;
    }
}

bool isSeparator(char c)
{
    return static_cast<unsigned char>(c) <= ' ' ? c != hidden
                                                : std::string_view("\"'()[]{}<>,;|=").find(c) != std::string_view::npos;
}

/// Returns "[file]" with the extension for a file name, "[path]" for a path; empty for any other word.
std::string pathPlaceholder(std::string_view word)
{
    while (word.ends_with('.') || word.ends_with(':')) {
        word.remove_suffix(1);
    }
    const std::string folded = foldCase(word);
    const auto ending = std::ranges::find_if(
        fileEndings, [&](std::string_view end) { return folded.size() > end.size() && folded.ends_with(end); });
    const bool hasFolders = word.find_first_of("/\\") != std::string_view::npos;
    const bool isPath = word.starts_with('/') || word.starts_with("~/") || word.starts_with("file:") ||
                        (word.size() > 2 && word[1] == ':' && (word[2] == '\\' || word[2] == '/'));
    if (ending != fileEndings.end()) {
        return "[file]" + std::string(*ending);
    }
    return word.size() > 1 && (isPath || (hasFolders && word.find(hidden) != std::string_view::npos)) ? "[path]" : "";
}

std::string withoutPlaces(std::string_view text)
{
    std::string clean;
    for (std::size_t at = 0; at < text.size();) {
        std::size_t end = at;
        while (end < text.size() && !isSeparator(text[end])) {
            ++end;
        }
        std::string_view word = text.substr(at, end - at);
        const std::string place = pathPlaceholder(word);
        if (place.empty()) {
            clean += word;
        } else {
            const std::size_t kept = word.find_last_not_of(".:") + 1;
            clean += place + std::string(word.substr(kept));
        }
        if (end < text.size()) {
            clean += text[end];
        }
        at = end + 1;
    }
    return clean;
}

}   // namespace

Redaction::Redaction() : home_(homeFolder())
{
    for (const std::string& name : {accountName(), accountFullName(), hostName()}) {
        if (name != "localhost") {
            addName(name);
        }
    }
    addPath(home_);
}

void Redaction::add(std::string_view identifier)
{
    if (identifier.size() >= 2) {
        identifiers_.insert(foldCase(identifier));
    }
}

void Redaction::addName(std::string_view name)
{
    add(name);
    forEachWord(name, [this](std::string_view word) {
        if (word.size() >= minWordBytes) {
            add(word);
        }
    });
}

void Redaction::addText(std::string_view text)
{
    const bool isOfTrade = isTechnicalWord(foldCase(text));
    if (!isOfTrade && text.size() >= minWordBytes) {
        add(text);
    }
    forEachWord(text, [this](std::string_view word) {
        const bool isNumber = std::ranges::all_of(word, [](char c) { return c >= '0' && c <= '9'; });
        if (word.size() >= (isNumber ? 5 : minWordBytes) && !isTechnicalWord(foldCase(word))) {
            add(word);
        }
    });
}

void Redaction::addPath(std::string_view path)
{
    while (!path.empty()) {
        const std::size_t end = std::min(path.find('/'), path.size());
        addText(path.substr(0, end));
        path.remove_prefix(std::min(end + 1, path.size()));
    }
}

std::string Redaction::redact(std::string_view text) const
{
    std::string clean(text);
    std::string folded = foldCase(clean);
    if (home_.size() > 1) {
        for (std::size_t at = 0; (at = clean.find(home_, at)) != std::string::npos;) {
            clean.replace(at, home_.size(), "~");
        }
        folded = foldCase(clean);
    }
    for (const std::string& identifier : identifiers_) {
        hide(identifier, clean, folded);
    }
    clean = redactUidsAndDates(withoutPlaces(clean));
    std::string readable;
    for (const char c : clean) {
        readable += c == hidden ? std::string("[name]") : std::string(1, c);
    }
    return readable;
}

}   // namespace angiopose::io
