#include "core/support/numbers.h"
#include "core/texture/texture_limits.h"
#include "tests/core/exchange/project/stored_field_settings.h"

namespace esm::stored {

namespace {

template<class Part> auto layerPart(std::size_t layer, const Part& part) {
    return [layer, part](Project& project) {
        return project.layers.size() > layer ? part(project.layers[layer]) : nullptr;
    };
}

/// What every layer stores that projects a photo.
void addLayer(Fields& fields, std::size_t i) {
    fields.push_back(field<std::vector<LandmarkPair>>(
        "landmarks",
        {{},
         {{{-largest, smallest}, Eigen::Vector3d::Constant(largest)}},
         std::vector<LandmarkPair>(texture_limits::mostLandmarks, LandmarkPair{{1, 2}, {3, 4, 5}})},
        layerPart(i, [](TextureLayer& l) { return &l.landmarks; })));
    fields.push_back(field<Eigen::Isometry3d>(
        "pose",
        {Eigen::Isometry3d::Identity(),
         Eigen::Isometry3d(Eigen::Translation3d(Eigen::Vector3d::Constant(-largest)))},
        layerPart(i, [](TextureLayer& l) { return &l.projector.pose; })));
}

void addPhotos(Fields& fields) {
    using namespace texture_limits;
    fields.push_back(field<std::vector<TextureLayer>>("layers", {{}}, [](Project& p) { return &p.layers; }));
    for (std::size_t i = 0; i < 3; ++i)
        addLayer(fields, i);
    fields.push_back(field<std::optional<Intrinsics>>(
        "intrinsics",
        {Intrinsics{smallest, smallest, -longestFocalLength, longestFocalLength},
         Intrinsics{longestFocalLength, longestFocalLength, smallest, -0.0}},
        layerPart(2, [](TextureLayer& l) { return &l.projector.intrinsics; })));
}

std::shared_ptr<const BrushStroke> strokeAt(BrushKind kind, bool most) {
    using namespace texture_limits;
    BrushStroke stroke;
    stroke.kind = kind;
    stroke.radius = most ? longestPhoto : shortestPhoto;
    stroke.softness = stroke.strength = most ? 1 : 0;
    const double place = most ? largest : -largest, normal = most ? largest : smallest;
    stroke.path = {{Eigen::Vector3d::Constant(place), {normal, 0, 0}}};
    if (kind == BrushKind::Colour || kind == BrushKind::Erase)
        stroke.shares = {most ? BrushShares{1, 0} : BrushShares{0, 1}};
    if (kind == BrushKind::Colour) stroke.colour.fill(most ? 255 : 0);
    if (copies(kind)) stroke.shift.setConstant(place);
    return std::make_shared<const BrushStroke>(stroke);
}

void addPainting(Fields& fields) {
    const auto painted = [](std::size_t layer, std::initializer_list<BrushKind> kinds) {
        std::vector<BrushStrokes> settings(3);
        for (const BrushKind kind : kinds)
            for (const bool most : {false, true})
                settings[most ? 2 : 1].push_back(strokeAt(kind, most));
        return field("strokes", settings, layerPart(layer, [](TextureLayer& l) { return &l.strokes; }));
    };
    fields.push_back(painted(0, {BrushKind::Erase, BrushKind::Restore}));
    fields.push_back(painted(
        3, {BrushKind::Erase, BrushKind::Restore, BrushKind::Colour, BrushKind::Clone, BrushKind::Heal}));
}

PhotoPreparation leastPreparation() {
    PhotoPreparation least;
    least.field = PhotoField::circle({-1e7, -1e7}, 1, 0);
    least.strokes = {{{{-1e7, -1e7}}, 0.5, 0, false}};
    least.highlightThreshold = 1;
    least.evenLight = smallest;
    least.whiteBalance = ColourGains{smallestGain, smallestGain, smallestGain};
    least.match = ColourMatch{{0.5, 0.5, 0.5}, {-300, -300, -300}};
    least.lens = Lens{LensKind::Fisheye, {1, 1, -1e7, -1e7}, {-1000, -1000, -1000, -1000, 0}};
    least.crop = PhotoCrop{0, 0, 1, 1};
    least.adjustment = {0, 1, 0.1, 0, 0, -180};
    return least;
}

PhotoPreparation mostPreparation() {
    PhotoPreparation most;
    most.field = PhotoField::circle({1e7, 1e7}, 1e7, 90);
    most.strokes = {{{{1e7, 1e7}, {0, 0}}, 5000, 1, true}};
    most.highlightThreshold = 255;
    most.evenLight = 1;
    most.whiteBalance = ColourGains{largestGain, largestGain, largestGain};
    most.match = ColourMatch{{2, 2, 2}, {300, 300, 300}};
    most.lens = Lens{LensKind::Pinhole, {1e7, 1e7, 1e7, 1e7}, {1000, 1000, 1000, 1000, 1000}};
    most.crop = PhotoCrop{15, 15, 1, 1};
    most.adjustment = {254, 255, 10, 2, 2, 180};
    return most;
}

/// What a preparation has in place of what the least one has.
PhotoPreparation leastShaped() {
    PhotoPreparation least;
    least.field = PhotoField{FieldShape::Ellipse, {-1e7, -1e7}, {1, 1}, -360, {}, 0};
    least.strokes = {{{{-1e7, -1e7}, {0, 0}, {1, 0}}, 0.5, 0, false, true}};
    least.highlightSensitivity = 0;
    return least;
}

PhotoPreparation mostShaped() {
    PhotoPreparation most;
    most.field =
        PhotoField{FieldShape::Polygon, {0, 0}, {0, 0}, 0, PhotoOutline(mostFieldCorners, {1e7, -1e7}), 90};
    most.strokes = {{{{1e7, 1e7}, {0, 0}, {1, 0}}, 5000, 1, true, true}};
    most.highlightSensitivity = 1;
    return most;
}

void addPreparation(Fields& fields) {
    StoredField preparations{"preparation", {}};
    for (const PhotoPreparation& preparation :
         {PhotoPreparation(), leastPreparation(), mostPreparation(), leastShaped(), mostShaped()})
        preparations.settings.push_back([preparation](Project& p) {
            if (p.layers.size() > 1) prepare(p.layers[1], preparation);
        });
    fields.push_back(preparations);
}

} // namespace

void addPhotoFields(Fields& fields) {
    addPhotos(fields);
    addPainting(fields);
    addPreparation(fields);
}

} // namespace esm::stored
