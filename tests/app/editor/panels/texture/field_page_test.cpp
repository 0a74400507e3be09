#include "app/editor/panels/texture/field_page.h"

#include "app/editor/panels/texture/photo_dialog.h"
#include "core/samples/samples.h"
#include "tests/app/editor_driver.h"

using namespace esm;

namespace {

PhotoField ellipse() {
    PhotoField field = PhotoField::circle({40, 30}, 25);
    field.radii.y() = 15;
    return field;
}

PhotoField polygon() {
    PhotoField field;
    field.shape = FieldShape::Polygon;
    field.corners = {{5, 5}, {60, 8}, {55, 50}, {8, 45}};
    return field;
}

} // namespace

TEST(FieldPage, LeavesAFieldAsItIsWhenItsPhotoIsOpened) {
    Document document(makeSample("ventricle"));
    Selection& selection = *new Selection(document);
    PreparationEdits& edits = *new PreparationEdits(document, selection);
    for (const PhotoField& field : {ellipse(), polygon()}) {
        document.edit("field", [&](Project& project) {
            TextureLayer layer;
            layer.photo = makeSamplePhoto("serosa");
            PhotoPreparation preparation;
            preparation.field = field;
            prepare(layer, preparation);
            project.layers = {layer};
            numberByPlace(project.layers);
        });
        selection.setPhoto(document.project().layers[0].id);
        const int steps = document.undoStack()->count();
        PhotoDialog dialog(document, edits);
        dialog.show();
        ESM_EVENTUALLY(!edits.isWorking());
        EXPECT_EQ(document.project().layers[0].preparation.field, field);
        EXPECT_EQ(document.undoStack()->count(), steps);
    }
}
