#pragma once

#include "app/editor/document/change.h"

#include <QObject>

#include <optional>
#include <vector>

namespace esm {

class Document;

/// Which region and which photo the window speaks of. Not part of the project, and no edit. What is added, by
/// an edit, its undoing or its redoing, is selected; and so is what undoing or redoing changes.
class Selection : public QObject {
    Q_OBJECT

public:
    explicit Selection(Document& document);

    /// None is the whole organ's base tissue.
    std::optional<RegionId> region() const { return m_region; }
    /// Nothing is selected where there is no such region, or no such photo.
    void setRegion(std::optional<RegionId> region);
    std::optional<LayerId> photo() const { return m_photo; }
    void setPhoto(std::optional<LayerId> photo);

    /// As they are now; null without one.
    const Region* selectedRegion() const;
    const TextureLayer* selectedLayer() const;

signals:
    void changed();

private:
    void followDocument(const Change& change);

    Document& m_document;
    std::optional<RegionId> m_region;
    std::optional<LayerId> m_photo;
    std::vector<Region> m_regions; ///< as they were when the selection last looked
    std::vector<TextureLayer> m_photos;
};

} // namespace esm
