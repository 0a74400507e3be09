#pragma once

#include "core/exchange/project/project_file.h"
#include "core/exchange/project/project_layout.h"
#include "core/exchange/project/zip_archive.h"
#include "core/support/errors.h"
#include "tests/core/exchange/overwrite.h"
#include "tests/support/exchange_projects.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace esm {

class ProjectFile : public testing::Test {
protected:
    using Json = nlohmann::ordered_json;

    std::string loadingError() const {
        try {
            loadProject(m_file);
        } catch (const FileError& error) {
            return error.what();
        }
        return "loaded";
    }

    /// Saves the rich project with one entry of its archive changed.
    template<typename Change> void saveChanged(const std::string& name, const Change& change) const {
        saveChangedOf(richProject(), name, change);
    }

    template<typename Change>
    void saveChangedOf(const Project& project, const std::string& name, const Change& change) const {
        saveProject(project, m_file);
        const Bytes bytes = readFile(m_file);
        const ZipReader archive(bytes);
        const Bytes text = archive.read(project_layout::manifest, 1 << 20);
        const Json manifest = Json::parse(text.begin(), text.end());
        std::vector<ZipEntry> entries{{project_layout::manifest, text, true}};
        for (const auto& array : manifest["arrays"].items())
            entries.push_back({array.key(), archive.read(array.key(), 1 << 20), true});
        for (const Json& photo : manifest["photos"]["files"])
            entries.push_back({photo["entry"], archive.read(photo["entry"], 1 << 20), false});
        const auto entry =
            std::find_if(entries.begin(), entries.end(), [&](const ZipEntry& e) { return e.name == name; });
        ASSERT_NE(entry, entries.end()) << name;
        change(entries, *entry);
        overwrite(m_file, makeZip(entries));
    }

    /// The same with one value of the manifest changed.
    template<typename Change> void changeManifest(const std::string& pointer, const Change& change) const {
        changeManifestOf(richProject(), pointer, change);
    }

    template<typename Change>
    void changeManifestOf(const Project& project, const std::string& pointer, const Change& change) const {
        saveChangedOf(project, project_layout::manifest, [&](auto&, ZipEntry& entry) {
            Json manifest = Json::parse(entry.content.begin(), entry.content.end());
            change(manifest.at(Json::json_pointer(pointer)));
            const std::string text = manifest.dump();
            entry.content.assign(text.begin(), text.end());
        });
    }

    void saveWithManifest(const std::string& pointer, const Json& value) const {
        changeManifest(pointer, [&](Json& old) { old = value; });
    }

    TemporaryFolder m_folder;
    std::filesystem::path m_file = m_folder / "organ.esm";
};

} // namespace esm
