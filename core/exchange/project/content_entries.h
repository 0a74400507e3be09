#pragma once

#include "core/exchange/project/project_content.h"
#include "core/exchange/project/project_layout.h"
#include "core/support/byte_order.h"
#include "core/support/json_reader.h"
#include "core/texture/texture_limits.h"

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace esm {

/// The entries of a project while they are read. Problems are collected, so that one pass finds all of them.
class ContentEntries {
public:
    /// @param steps entries to read, photos to decode and to prepare
    ContentEntries(const ContentSource& entries, SharedParts& shared, const Progress& progress,
                   std::size_t steps, std::vector<std::string>& problems)
        : m_entries(entries), m_shared(shared), m_parts(progress), m_step(1 / static_cast<double>(steps + 1)),
          m_problems(problems) {}

    /// What another project has read from the same entries already, or else what `make` gives.
    /// @param kind with what else it depends on
    template<class Part, class Make>
    std::shared_ptr<const Part> shared(std::string kind, const std::vector<std::string>& entries,
                                       const Make& make) {
        if (!m_entries.nameOfContent) return make();
        for (const std::string& entry : entries)
            kind += '\n' + m_entries.nameOfContent(entry);
        std::shared_ptr<const void>& known = m_shared.byContent[kind];
        if (!known) {
            const std::size_t problems = m_problems.size();
            std::shared_ptr<const Part> made = make();
            if (m_problems.size() > problems) return made;
            known = made;
        }
        return std::static_pointer_cast<const Part>(known);
    }

    /// An entry of `size` bytes; empty, and a problem, where it cannot be had. What fails counts too, so that
    /// no file can have the same bytes unpacked again and again.
    Bytes bytes(const std::string& entry, std::uint64_t size);

    /// A photo, decoded only where the pixels it claims leave room for the other ones.
    /// @throws FileError where they do not, or where it is none
    std::shared_ptr<const Photo> photo(const std::string& name, Bytes encoded);

    /// Prepares a layer's photo, where the picture has room beside the other ones.
    void prepare(const JsonReader& reader, TextureLayer& layer);

    /// The numbers of an array in groups of `components`.
    template<typename T>
    std::vector<T> array(const JsonReader& arrays, const char* entry, std::size_t components) {
        const JsonReader declared = arrays.member(entry);
        const std::uint64_t count = declared.integer(0, project_layout::largestProject / sizeof(T));
        if (count % components != 0) {
            declared.addProblem("should be a multiple of " + std::to_string(components));
            return {};
        }
        const Bytes content = bytes(entry, count * sizeof(T));
        std::vector<T> values;
        values.reserve(content.size() / sizeof(T));
        for (std::size_t i = 0; i < content.size(); i += sizeof(T))
            values.push_back(littleEndian<T>(&content[i]));
        return values;
    }

    /// The same, all of them finite.
    std::vector<double> numbers(const JsonReader& arrays, const char* entry, std::size_t components);

    /// Whole numbers below `limit`. Any, where what they count could not be read, which is told already.
    std::vector<std::uint32_t> indices(const JsonReader& arrays, const char* entry, std::size_t components,
                                       std::size_t limit);

    bool foundProblems() const { return !m_problems.empty(); }

private:
    Progress nextStep() { return m_parts.next(m_step); }

    /// False where no project has such a picture yet.
    bool takePrepared(TextureLayer& layer, const PhotoPreparation& preparation) const;
    void takePixels(std::uint64_t pixels, const std::string& name);

    const ContentSource& m_entries;
    SharedParts& m_shared;
    ProgressParts m_parts;
    double m_step; ///< share of all
    std::vector<std::string>& m_problems;
    std::set<std::string> m_named;
    std::uint64_t m_budget = project_layout::largestProject;
    std::uint64_t m_pixels = texture_limits::mostPixelsOfAllPhotos;
};

/// Three corners in the plane for each six numbers.
std::vector<std::array<Eigen::Vector2d, 3>> flatTriangles(const std::vector<double>& numbers);

} // namespace esm
