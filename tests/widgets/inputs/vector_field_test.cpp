#include "widgets/inputs/vector_field.h"

#include "widgets/inputs/quantity_formats.h"

#include <gtest/gtest.h>
#include <QTest>

using namespace esm;

TEST(VectorField, AnnouncesAllThreeWhenOneIsTyped) {
    VectorField field(withoutUnit(lengthFormat(-1000)));
    field.setValue(Eigen::Vector3d(0.01, 0.02, 0.03));
    EXPECT_EQ(field.field(1)->text(), "20.0");
    std::optional<Eigen::Vector3d> edited;
    QObject::connect(&field, &VectorField::valueEdited,
                     [&](const Eigen::Vector3d& value) { edited = value; });
    field.field(1)->selectAll();
    QTest::keyClicks(field.field(1), "-5");
    QTest::keyClick(field.field(1), Qt::Key_Return);
    ASSERT_TRUE(edited);
    EXPECT_TRUE(edited->isApprox(Eigen::Vector3d(0.01, -0.005, 0.03)));
}

TEST(VectorField, ShowsDashesWithoutAValue) {
    VectorField field(withoutUnit(lengthFormat(-1000)));
    field.setValue(Eigen::Vector3d::Zero().eval());
    field.setValue(std::nullopt);
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_EQ(field.field(axis)->text(), QString(QChar(0x2013)));
}
