#pragma once

#include "app/editor/document/document.h"
#include "app/editor/document/selection.h"
#include "app/editor/tools/painting.h"

#include <random>

namespace esm {

/// A tube with a region and a layer to paint on.
Project projectToEdit();

/// What a user does to a document, at random.
class RandomEdits {
public:
    /// @param longestDrag of a slider, in edits that follow each other
    RandomEdits(Document& document, Selection& selection, std::uint32_t seed, std::uint32_t longestDrag = 5)
        : m_document(document), m_selection(selection), m_painting(document, selection), m_random(seed),
          m_longestDrag(longestDrag) {}

    /// Makes, grows, ends, undoes or redoes one step; may come to nothing.
    void next();
    std::uint32_t below(std::uint32_t size) { return static_cast<std::uint32_t>(m_random() % size); }

private:
    double share() { return std::uniform_real_distribution<double>(0, 1)(m_random); }
    const Region* anyRegion();
    void slide();
    void changeRegion();
    void addOrRemoveRegion();
    void paint();
    void walk();
    void rename();

    Document& m_document;
    Selection& m_selection;
    Painting m_painting;
    std::mt19937 m_random;
    bool m_isPainting = false;
    std::uint32_t m_longestDrag, m_dragLeft = 0;
};

/// Digests of documents, worked out anew from every number they hold. The same for the same.
class DocumentDigests {
public:
    /// The undo list: each state with the identities of its parts, the steps' names and the place in it.
    std::string of(const DocumentState& state);
    std::string of(const std::shared_ptr<const Project>& project);

private:
    std::map<std::shared_ptr<const Project>, std::string> m_projects;
    std::map<std::pair<std::shared_ptr<const void>, std::string>, std::string> m_pieces;
};

} // namespace esm
