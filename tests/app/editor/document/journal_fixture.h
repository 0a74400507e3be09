#pragma once

#include "app/editor/document/journal.h"
#include "tests/app/editor/document/random_edits.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <fstream>

namespace esm {

/// A document with a journal, and what another program would find of it.
class JournalTest : public testing::Test {
protected:
    void setMass(double mass, EditKind kind = EditKind::Alone) {
        document.edit(
            "mass", [mass](Project& project) { project.base.mass = mass; }, MergeKey(kind));
    }

    std::vector<std::filesystem::path> journals() const {
        std::vector<std::filesystem::path> found;
        std::error_code none;
        for (const auto& entry : std::filesystem::directory_iterator(recovery, none))
            if (entry.path().extension() == journalEnding) found.push_back(entry.path());
        return found;
    }

    /// What is on the disk, as if the program ended here, to be looked at by another one.
    LeftBehind leftByAKill(Journal& journal) {
        journal.finish();
        return leftByAKill();
    }
    LeftBehind leftByAKill() {
        const auto place = folder / ("left" + std::to_string(++m_copies)) / "left.journal";
        std::filesystem::create_directories(place.parent_path());
        std::filesystem::copy(journals().at(0), place, std::filesystem::copy_options::recursive);
        return {place, {}, {}, nullptr};
    }

    static std::string recordsText(const std::filesystem::path& journal) {
        std::ifstream in(journal / "records", std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    static void overwriteRecords(const std::filesystem::path& journal, const std::string& text) {
        std::ofstream(journal / "records", std::ios::binary) << text;
    }

    TemporaryFolder folder;
    std::filesystem::path recovery = folder / "recovery";
    Document document{projectToEdit()};
    Selection selection{document};

private:
    int m_copies = 0;
};

} // namespace esm
