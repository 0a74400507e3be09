#include "core/exchange/project/project_content.h"
#include "core/exchange/project/project_file.h"
#include "core/exchange/project/zip_archive.h"
#include "core/support/errors.h"
#include "tests/fuzz/fuzz_target.h"
#include "tests/fuzz/mutation.h"

#include <zip.h>

namespace esm::fuzz {

namespace {

/// In the archive's order; empty where it is none.
std::vector<std::string> entriesIn(const Bytes& archive) {
    zip_source_t* const source = zip_source_buffer_create(archive.data(), archive.size(), 0, nullptr);
    const std::unique_ptr<zip_t, decltype(&zip_discard)> opened(
        zip_open_from_source(source, ZIP_RDONLY, nullptr), &zip_discard);
    std::vector<std::string> names;
    if (!opened) zip_source_free(source);
    for (zip_int64_t i = 0; opened && i < zip_get_num_entries(opened.get(), 0); ++i)
        if (const char* name = zip_get_name(opened.get(), static_cast<zip_uint64_t>(i), ZIP_FL_ENC_RAW))
            names.emplace_back(name);
    return names;
}

/// The archive with one of its entries changed, none of them packed; empty where it cannot be read.
Bytes withChangedEntry(const Bytes& archive, std::uint32_t seed) {
    constexpr std::uint64_t largest = 1 << 20;
    try {
        const ZipReader reader(archive);
        std::vector<ZipEntry> entries;
        for (const std::string& name : entriesIn(archive))
            entries.push_back({name, reader.read(name, largest), false});
        if (entries.empty()) return {};
        // The manifest stands first and says most.
        ZipEntry& changed = entries[seed % 2 == 0 ? 0 : seed / 2 % entries.size()];
        changed.content = mutatedPart(std::move(changed.content), seed / 64);
        return makeZip(entries);
    } catch (const InvalidModel&) {
        return {};
    }
}

/// A project's entries as a file would keep them.
ReadContent readAgain(const ProjectContent& content) {
    std::map<std::string, Bytes> entries;
    for (const ContentPiece& piece : content.pieces) {
        const Bytes bytes = piece.bytes();
        Bytes& entry = entries[piece.entry];
        entry.insert(entry.end(), bytes.begin(), bytes.end());
    }
    SharedParts none;
    return projectFrom(
        content.manifest,
        {[&](const std::string& entry, std::uint64_t, const Progress&) { return entries.at(entry); }}, none);
}

} // namespace

/// Project files, and that what was read is stored so that it comes back.
void readInput(const Bytes& content) {
    const FileInMemory file(content);
    const Project project = openProject(file.path()).project;
    const ProjectContent stored = contentOf(project);
    const ReadContent again = readAgain(stored);
    expect(again.problems.empty(), again.problems.empty() ? "" : again.problems.front());
    expect(contentOf(again.project).manifest == stored.manifest, "another project");
}

} // namespace esm::fuzz

/// Changes an entry of the archive, as most changes of the file itself are found by its check sums.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned seed) {
    const esm::fuzz::FuzzedInput input{{data, most}, size, seed};
    if (seed % 16 == 0) return input.mutated();
    return input.replacedBy(esm::fuzz::withChangedEntry(input.content(), seed / 16));
}
