#include "core/exchange/project/zip_archive.h"

#include "core/support/errors.h"

#include <zip.h>

#include <algorithm>
#include <new>

namespace esm {

namespace {

struct FreeSource {
    void operator()(zip_source_t* source) const { zip_source_free(source); }
};
struct CloseFile {
    void operator()(zip_file_t* file) const { zip_fclose(file); }
};
using Archive = std::unique_ptr<zip_t, decltype(&zip_discard)>;
using ZipSource = std::unique_ptr<zip_source_t, FreeSource>;
using File = std::unique_ptr<zip_file_t, CloseFile>;

/// Writing to memory fails only where memory does.
void require(bool success) {
    if (!success) throw std::bad_alloc();
}

void addEntry(zip_t* archive, const ZipEntry& entry) {
    constexpr std::uint16_t midnight = 0, firstOf1980 = (1 << 5) | 1;
    // Deflate's higher levels save 2 % of binary arrays and cost thrice the time.
    constexpr std::uint32_t fastest = 1;
    ZipSource source(zip_source_buffer(archive, entry.content.data(), entry.content.size(), 0));
    require(source != nullptr);
    const zip_int64_t added = zip_file_add(archive, entry.name.c_str(), source.get(), ZIP_FL_ENC_UTF_8);
    require(added >= 0);
    static_cast<void>(source.release()); // the archive has it now
    const auto index = static_cast<zip_uint64_t>(added);
    require(zip_file_set_dostime(archive, index, midnight, firstOf1980, 0) == 0);
    require(zip_set_file_compression(archive, index, entry.compressed ? ZIP_CM_DEFLATE : ZIP_CM_STORE,
                                     fastest) == 0);
}

/// What the archive tells while it packs. Calls through C, which exceptions may not pass.
class Packing {
public:
    Packing(zip_t* archive, const Progress& progress) : m_progress(progress) {
        constexpr double precision = 0.001;
        zip_register_progress_callback_with_state(archive, precision, tell, nullptr, this);
        zip_register_cancel_callback_with_state(archive, shouldStop, nullptr, this);
    }
    bool isCancelled() const { return m_isCancelled; }

private:
    static void tell(zip_t*, double fraction, void* packing) {
        static_cast<Packing*>(packing)->m_fraction = fraction;
    }
    static int shouldStop(zip_t*, void* packing) { return static_cast<Packing*>(packing)->ask() ? 0 : 1; }

    bool ask() {
        m_isCancelled = m_isCancelled || (m_progress && !m_progress(m_fraction));
        return !m_isCancelled;
    }

    const Progress& m_progress;
    double m_fraction = 0;
    bool m_isCancelled = false;
};

Bytes contentOf(zip_source_t* source) {
    zip_stat_t status;
    zip_stat_init(&status);
    require(zip_source_stat(source, &status) == 0 && zip_source_open(source) == 0);
    Bytes content(status.size);
    const zip_int64_t got = zip_source_read(source, content.data(), content.size());
    zip_source_close(source);
    require(got == static_cast<zip_int64_t>(content.size()));
    return content;
}

} // namespace

Bytes makeZip(const std::vector<ZipEntry>& entries, const Progress& progress) {
    const ZipSource memory(zip_source_buffer_create(nullptr, 0, 0, nullptr));
    require(memory != nullptr);
    Archive archive(zip_open_from_source(memory.get(), ZIP_CREATE | ZIP_TRUNCATE, nullptr), &zip_discard);
    require(archive != nullptr);
    zip_source_keep(memory.get()); // the archive's own reference goes with zip_close()
    for (const ZipEntry& entry : entries)
        addEntry(archive.get(), entry);
    const Packing packing(archive.get(), progress);
    const bool isPacked = zip_close(archive.get()) == 0;
    if (packing.isCancelled()) throw Cancelled();
    require(isPacked);
    static_cast<void>(archive.release()); // closed
    return contentOf(memory.get());
}

struct ZipReader::Handle {
    Archive archive{nullptr, &zip_discard};
};

ZipReader::ZipReader(const Bytes& archive) : m_handle(std::make_unique<Handle>()) {
    ZipSource source(zip_source_buffer_create(archive.data(), archive.size(), 0, nullptr));
    require(source != nullptr);
    m_handle->archive.reset(zip_open_from_source(source.get(), ZIP_RDONLY | ZIP_CHECKCONS, nullptr));
    if (!m_handle->archive) throw InvalidModel("is damaged or cut off, or no zip archive");
    static_cast<void>(source.release()); // the archive has it now
}

ZipReader::~ZipReader() = default;

Bytes ZipReader::read(const std::string& entry, std::uint64_t largest, const Progress& progress) const {
    const zip_int64_t index = zip_name_locate(m_handle->archive.get(), entry.c_str(), 0);
    if (index < 0) throw InvalidModel("the entry " + entry + " is missing");
    const File file(zip_fopen_index(m_handle->archive.get(), static_cast<zip_uint64_t>(index), 0));
    if (!file) throw InvalidModel("the entry " + entry + " is damaged or encrypted");
    Bytes content;
    const auto chunk = static_cast<std::size_t>(std::min<std::uint64_t>(1 << 20, largest + 1));
    while (true) {
        const std::size_t before = content.size();
        reportProgress(progress, static_cast<double>(before) / static_cast<double>(largest + 1));
        content.resize(before + chunk);
        const zip_int64_t got = zip_fread(file.get(), content.data() + before, chunk);
        if (got < 0) throw InvalidModel("the entry " + entry + " is damaged");
        content.resize(before + static_cast<std::size_t>(got));
        if (got == 0) return content;
        if (content.size() > largest)
            throw InvalidModel("the entry " + entry + " is larger than the " + std::to_string(largest) +
                               " bytes it should have");
    }
}

} // namespace esm
