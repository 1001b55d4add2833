#include "io/simulation/study_file.h"

#include "io/messages/messages.h"
#include "io/support/file_error.h"
#include "io/support/input_bytes.h"
#include "io/support/json_text.h"
#include "io/vessel_tree_file.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <variant>

namespace angiopose::io {
namespace {

using Json = nlohmann::ordered_json;

/// Numeric key of a study with its limits.
struct NumberKey {
    std::string_view key;
    std::variant<double*, int*> place;
    double least = 0.0;
    double most = 0.0;
};

/// Reads the members of one object and keeps the first error.
class ObjectReader {
public:
    ObjectReader(const Json& object, std::string where, const std::string& path)
        : object_(object), where_(std::move(where)), path_(path)
    {
    }

    core::Status numbers(const std::vector<NumberKey>& keys)
    {
        for (const NumberKey& row : keys) {
            if (const auto found = take(row.key)) {
                if (auto status = setNumber(row, *found); !status) {
                    return status;
                }
            }
        }
        return core::Done{};
    }

    const Json* take(std::string_view key)
    {
        known_.emplace_back(key);
        const auto found = object_.find(key);
        return found == object_.end() ? nullptr : &*found;
    }

    /// Fails if the object has members that were not read. Must be called last.
    core::Status rejectUnknownKeys() const
    {
        for (const auto& [key, value] : object_.items()) {
            if (std::ranges::find(known_, key) == known_.end()) {
                std::string list;
                for (const std::string& name : known_) {
                    list += (list.empty() ? "" : ", ") + name;
                }
                return fileError(path_, messages::studyUnknownKey(key, where_, list));
            }
        }
        return core::Done{};
    }

    core::Error missing(std::string_view key) const { return fileError(path_, messages::studyMissingKey(where_, key)); }
    core::Error wrong(std::string_view key, const Json& value) const
    {
        return fileError(path_, messages::studyWrongValue(key, where_, value.dump().substr(0, 60)));
    }

private:
    core::Status setNumber(const NumberKey& row, const Json& value) const
    {
        if (!value.is_number() || (std::holds_alternative<int*>(row.place) && !value.is_number_integer())) {
            return wrong(row.key, value);
        }
        const double number = value.get<double>();
        if (!(number >= row.least && number <= row.most)) {
            const auto limit = [](double given) { return core::Quantity{given, core::Quantity::significantDigits}; };
            return fileError(path_, messages::studyOutOfRange(row.key, where_, limit(row.least), limit(row.most)));
        }
        if (const auto* real = std::get_if<double*>(&row.place)) {
            **real = number;
        } else {
            *std::get<int*>(row.place) = static_cast<int>(number);
        }
        return core::Done{};
    }

    const Json& object_;
    std::string where_;
    const std::string& path_;
    std::vector<std::string> known_;
};

bool isFolderName(const std::string& text)
{
    return !text.empty() && !text.starts_with('.') && std::ranges::all_of(text, [](unsigned char c) {
        return std::isalnum(c) || c == '.' || c == '-' || c == '_';
    });
}

core::Result<core::StudyTree> treeFrom(const Json& json, const std::string& where, const std::string& path)
{
    core::StudyTree tree;
    ObjectReader reader(json, where, path);
    if (const Json* file = reader.take("file")) {
        if (!file->is_string()) {
            return reader.wrong("file", *file);
        }
        const auto treePath = std::filesystem::path(path).parent_path() / file->get<std::string>();
        auto given = readVesselTree(treePath.string());
        if (!given) {
            return given.error();
        }
        tree.given = std::make_shared<const core::VesselTree>(std::move(given).value());
    } else if (auto status = reader.numbers({{"grown", &tree.count, 1, 100000},
                                             {"branches", &tree.grown.branchCount, 1, 200},
                                             {"extentMm", &tree.grown.extentMm, 20, 600},
                                             {"pointSpacingMm", &tree.grown.pointSpacingMm, 0.1, 10}});
               !status) {
        return status.error();
    }
    if (auto status = reader.numbers({{"rootRadiusMm", &tree.grown.rootRadiusMm, 0.3, 20}}); !status) {
        return status.error();
    }
    const auto status = reader.rejectUnknownKeys();
    return status ? core::Result<core::StudyTree>(std::move(tree)) : core::Result<core::StudyTree>(status.error());
}

core::Status headerFrom(const Json& json, const std::string& where, const std::string& path, core::HeaderErrors& errors)
{
    if (!json.is_object()) {
        return fileError(path, messages::studyWrongValue("header", where, json.dump().substr(0, 60)));
    }
    ObjectReader reader(json, "header of " + where, path);
    if (auto status = reader.numbers({{"distancePercent", &errors.distancePercent, 0, 20},
                                      {"spacingPercent", &errors.spacingPercent, 0, 20},
                                      {"angleDeg", &errors.angleDeg, 0, 30}});
        !status) {
        return status;
    }
    return reader.rejectUnknownKeys();
}

core::Status timingFrom(const Json& json, const std::string& where, const std::string& path,
                        core::ContrastTiming& timing)
{
    if (!json.is_object()) {
        return fileError(path, messages::studyWrongValue("contrast", where, json.dump().substr(0, 60)));
    }
    ObjectReader reader(json, "contrast of " + where, path);
    if (auto status = reader.numbers({{"firstS", &timing.firstS, -10, 60},
                                      {"runS", &timing.runS, 0.1, 120},
                                      {"fillingS", &timing.fillingS, 0.05, 30},
                                      {"injectionS", &timing.injectionS, 0.05, 60},
                                      {"riseS", &timing.riseS, 0.01, 10},
                                      {"washoutS", &timing.washoutS, 0.01, 60}});
        !status) {
        return status;
    }
    return reader.rejectUnknownKeys();
}

core::Result<core::StudySetting> settingFrom(const Json& json, const std::string& where, const std::string& path)
{
    core::StudySetting setting;
    core::DsaOptions& dsa = setting.dsa;
    ObjectReader reader(json, where, path);
    const Json* name = reader.take("name");
    if (name == nullptr || !name->is_string() || !isFolderName(name->get<std::string>())) {
        return name == nullptr ? reader.missing("name") : reader.wrong("name", *name);
    }
    setting.name = name->get<std::string>();
    if (auto status = reader.numbers({{"deformationMm", &dsa.nonRigidStdMm, 0, 10},
                                      {"missingBranches", &dsa.missingBranchShare, 0, 1},
                                      {"extraBranches", &dsa.extraBranchShare, 0, 1},
                                      {"photons", &dsa.photonCount, 10, 1e7},
                                      {"catheter", &dsa.catheterProbability, 0, 1},
                                      {"shutter", &dsa.shutterProbability, 0, 1},
                                      {"maskMotionPx", &dsa.maskMotionPx, 0, 20},
                                      {"frames", &dsa.frameCount, 1, 200},
                                      {"width", &dsa.width, 64, 4096},
                                      {"height", &dsa.height, 64, 4096}});
        !status) {
        return status.error();
    }
    if (const Json* header = reader.take("header")) {
        if (auto status = headerFrom(*header, where, path, setting.header); !status) {
            return status.error();
        }
    }
    if (const Json* contrast = reader.take("contrast")) {
        if (auto status = timingFrom(*contrast, where, path, dsa.timing); !status) {
            return status.error();
        }
    }
    const auto status = reader.rejectUnknownKeys();
    return status ? core::Result<core::StudySetting>(std::move(setting))
                  : core::Result<core::StudySetting>(status.error());
}

/// Returns the items of an array of objects, each created by `make`; fails if the array is empty.
template <class Item>
core::Status readList(ObjectReader& reader, std::string_view key, const std::string& path,
                      core::Result<Item> (*make)(const Json&, const std::string&, const std::string&),
                      std::vector<Item>& items)
{
    const Json* list = reader.take(key);
    if (list == nullptr) {
        return reader.missing(key);
    }
    if (!list->is_array() || list->empty()) {
        return reader.wrong(key, *list);
    }
    for (std::size_t k = 0; k < list->size(); ++k) {
        if (!(*list)[k].is_object()) {
            return reader.wrong(key, (*list)[k]);
        }
        auto item = make((*list)[k], std::string(key) + "[" + std::to_string(k) + "]", path);
        if (!item) {
            return item.error();
        }
        items.push_back(std::move(item).value());
    }
    return core::Done{};
}

core::Status findTwins(const std::vector<core::StudySetting>& settings, const std::string& path)
{
    std::set<std::string> names;
    for (const core::StudySetting& setting : settings) {
        if (!names.insert(setting.name).second) {
            return fileError(path, messages::studyNameTwice(setting.name));
        }
    }
    return core::Done{};
}

core::Result<core::SimulatedStudy> studyFrom(const Json& json, const std::string& path)
{
    core::SimulatedStudy study;
    ObjectReader reader(json, "the study", path);
    const Json* format = reader.take("format");
    const Json* version = reader.take("version");
    if (format == nullptr || *format != "angiopose-study" || version == nullptr || *version != 1) {
        return fileError(path, messages::studyNoStudy());
    }
    if (const Json* name = reader.take("name"); name != nullptr && name->is_string()) {
        study.name = name->get<std::string>();
    }
    if (const Json* seed = reader.take("seed")) {
        if (!seed->is_number_unsigned()) {
            return reader.wrong("seed", *seed);
        }
        study.seed = seed->get<std::uint64_t>();
    }
    core::Status status = reader.numbers({{"casesPerSetting", &study.casesPerSetting, 1, 1000000}});
    status = status ? readList(reader, "trees", path, treeFrom, study.trees) : status;
    status = status ? readList(reader, "settings", path, settingFrom, study.settings) : status;
    status = status ? findTwins(study.settings, path) : status;
    status = status ? reader.rejectUnknownKeys() : status;
    return status ? core::Result<core::SimulatedStudy>(std::move(study))
                  : core::Result<core::SimulatedStudy>(status.error());
}

}   // namespace

core::Result<core::SimulatedStudy> readStudy(const std::string& path)
{
    const auto content = openInput(path);
    if (!content) {
        return content.error();
    }
    if (const auto valid = checkJson(content.value().view(), path); !valid) {
        return valid.error();
    }
    const Json json = Json::parse(content.value().view());
    return json.is_object() ? studyFrom(json, path)
                            : core::Result<core::SimulatedStudy>(fileError(path, messages::studyNoStudy()));
}

}   // namespace angiopose::io
