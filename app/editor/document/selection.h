#pragma once

#include "app/editor/document/change.h"

#include <QObject>

#include <cstddef>
#include <optional>
#include <vector>

namespace esm {

class Document;

/// Which region and which photo the window speaks of. Not part of the project, and no edit. What is added, by
/// an edit, its undoing or its redoing, is selected; what is selected stays so where it moves.
class Selection : public QObject {
    Q_OBJECT

public:
    explicit Selection(Document& document);

    /// Index into the project's regions; none is the whole organ's base tissue.
    std::optional<std::size_t> region() const { return m_region; }
    void setRegion(std::optional<std::size_t> region);
    /// Index into the project's photos.
    std::optional<std::size_t> photo() const { return m_photo; }
    void setPhoto(std::optional<std::size_t> photo);

signals:
    void changed();

private:
    void followDocument(const Change& change);

    Document& m_document;
    std::optional<std::size_t> m_region, m_photo;
    std::vector<Region> m_regions; ///< as they were when the selection last looked
    std::vector<TextureLayer> m_photos;
};

} // namespace esm
