#include "app/editor/panels/texture/field_page.h"

#include "app/editor/panels/texture/page_row.h"
#include "widgets/inputs/enabling.h"
#include "widgets/inputs/quiet_label.h"

#include <Eigen/Geometry>

namespace esm {

namespace {

constexpr std::size_t cornersOfEllipse = 12; ///< when it becomes a polygon

NumberFormat trimFormat() {
    NumberFormat format;
    format.unit = QStringLiteral("%");
    format.decimals = 1;
    format.minimum = 0;
    format.maximum = 90;
    format.step = 0.5;
    return format;
}

/// The ellipse that fills the same box, turned as the field was; as a circle, of the mean radius.
PhotoField asEllipse(const PhotoField& field, bool isCircle) {
    PhotoField ellipse = field;
    if (field.shape == FieldShape::Polygon) {
        Eigen::AlignedBox2d box;
        for (const Eigen::Vector2d& corner : field.corners)
            box.extend(corner);
        ellipse = PhotoField::circle(box.center(), 1, field.trim);
        ellipse.radii = (0.5 * box.sizes()).cwiseMax(1);
    }
    return isCircle ? PhotoField::circle(ellipse.centre, ellipse.radii.mean(), field.trim) : ellipse;
}

PhotoField asPolygon(const PhotoField& field) {
    if (field.shape == FieldShape::Polygon) return field;
    PhotoField polygon;
    polygon.shape = FieldShape::Polygon;
    polygon.trim = field.trim;
    const PhotoOutline rim = outlineOf(field, false);
    for (std::size_t i = 0; i < cornersOfEllipse; ++i)
        polygon.corners.push_back(rim[i * rim.size() / cornersOfEllipse]);
    return polygon;
}

} // namespace

FieldPage::FieldPage(PreparationEdits& edits, PhotoCanvas& canvas, QWidget* parent)
    : QWidget(parent), m_edits(edits), m_canvas(canvas), m_find(new QPushButton(tr("&Find"), this)),
      m_none(new QPushButton(tr("&No field"), this)), m_shapes(new QButtonGroup(this)),
      m_trim(new NumberField(trimFormat(), this)) {
    layOut();
    connect(m_find, &QPushButton::clicked, this, [this] {
        m_edits.edit(tr("Mask field"), [](PreparationWish& wish) {
            wish.preparation.field.reset();
            wish.find.field = true;
        });
    });
    connect(m_none, &QPushButton::clicked, this,
            [this] { setField(tr("Show photo outside its field"), std::nullopt); });
    connect(m_trim, &NumberField::valueEdited, this, [this](double trim) {
        if (std::optional<PhotoField> field = m_edits.wanted().preparation.field) {
            field->trim = trim;
            setField(tr("Trim field"), field);
        }
    });
    connect(m_trim, &NumberField::gestureFinished, &m_edits, &PreparationEdits::finishGesture);
    connect(&canvas, &PhotoCanvas::fieldDrawn, this,
            [this](const PhotoField& field) { setField(tr("Draw field"), field); });
    connect(&canvas, &PhotoCanvas::fieldDropped, this, [this](const std::optional<PhotoField>& before) {
        setField(tr("Draw field"), before);
        m_edits.finishGesture();
    });
    m_shapes->button(Circle)->setChecked(true); // a field that there is shows its own, see showField()
    canvas.setFieldShape(FieldShape::Ellipse, true);
}

void FieldPage::layOut() {
    QHBoxLayout* row = pageRow(this);
    m_find->setObjectName(QStringLiteral("findField"));
    m_find->setToolTip(tr("Look for the endoscope's picture: round, cut off, squeezed or with corners"));
    row->addWidget(m_find);
    const auto add = [&](Shape shape, const QString& text, const QString& does) {
        auto* button = new QPushButton(text, this);
        button->setCheckable(true);
        button->setObjectName(QStringLiteral("quietButton"));
        button->setToolTip(does);
        m_shapes->addButton(button, shape);
        row->addWidget(button);
        connect(button, &QPushButton::clicked, this, [this, shape] { choose(shape); });
    };
    add(Circle, tr("Circ&le"), tr("Drag from its middle; the squares move and size it"));
    add(Ellipse, tr("&Ellipse"), tr("Drag from its middle; the outermost square turns it"));
    add(Polygon, tr("&Polygon"), tr("Drag around it; corners can be moved, and pulled out of a side"));
    m_trim->setObjectName(QStringLiteral("fieldTrim"));
    m_trim->setMaximumWidth(pageNumberWidth);
    m_trim->setToolTip(
        tr("Share of the field's size that is left away at its rim, where the picture is blurred"));
    row->addWidget(quietLabel(tr("&Trim"), this, m_trim));
    row->addWidget(m_trim);
    row->addWidget(m_none);
    row->addStretch();
    for (QPushButton* button : findChildren<QPushButton*>())
        button->setAutoDefault(false);
}

/// A field that is there becomes one of that shape.
void FieldPage::choose(Shape shape) {
    m_shapes->button(shape)->setChecked(true);
    m_canvas.setFieldShape(shape == Polygon ? FieldShape::Polygon : FieldShape::Ellipse, shape == Circle);
    const std::optional<PhotoField> field = m_edits.wanted().preparation.field;
    if (!field) return;
    const PhotoField shaped = shape == Polygon ? asPolygon(*field) : asEllipse(*field, shape == Circle);
    if (shaped == *field) return;
    setField(tr("Change field's shape"), shaped);
    m_edits.finishGesture();
}

void FieldPage::setField(const QString& text, const std::optional<PhotoField>& field) {
    m_edits.edit(
        text,
        [=](PreparationWish& wish) {
            wish.preparation.field = field;
            wish.find.field = false;
        },
        EditKind::Field);
}

void FieldPage::showField() {
    const std::optional<PhotoField> field = m_edits.wanted().preparation.field;
    m_canvas.setField(field);
    m_trim->setValue(field ? std::optional(field->trim) : std::nullopt);
    enable(m_trim, field.has_value(), m_trim->toolTip(), m_trim->toolTip());
    enable(m_none, field.has_value(), tr("Show the whole photo"), tr("The whole photo is shown"));
    if (!field) return;
    const bool isPolygon = field->shape == FieldShape::Polygon;
    const bool keepsEllipse = !isPolygon && field->isCircle() && m_shapes->checkedId() == Ellipse;
    const Shape shape = isPolygon ? Polygon : field->isCircle() && !keepsEllipse ? Circle : Ellipse;
    m_shapes->button(shape)->setChecked(true);
    m_canvas.setFieldShape(field->shape, shape == Circle);
}

} // namespace esm
