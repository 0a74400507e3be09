#include "app/editor/dialogs/body_question.h"

#include <gtest/gtest.h>
#include <QComboBox>
#include <QLabel>
#include <QRadioButton>

using namespace esm;

namespace {

constexpr double meanEdge = 0.005; // m

struct AskedBody {
    explicit AskedBody(std::size_t vertices = 10000, bool isClosed = true) {
        question.setSurface(vertices, isClosed, meanEdge);
    }
    void choose(int body) {
        question.findChild<QRadioButton*>(QStringLiteral("importBody%1").arg(body))->click();
    }
    QString work(int body) const {
        return question.findChild<QLabel*>(QStringLiteral("importWork%1").arg(body))->text();
    }
    QComboBox* detail() const { return question.findChild<QComboBox*>(QStringLiteral("importDetail")); }
    NumberField* nodes() const { return question.findChild<NumberField*>("importNodes"); }

    BodyQuestion question;
};

constexpr int hollow = 0, walled = 1, prisms = 2, solid = 3;

} // namespace

TEST(BodyQuestion, IsHollowAndBendsFreelyUnlessAskedFor) {
    AskedBody asked;
    EXPECT_EQ(asked.question.choice().detail.kind, Detail::Kind::EveryVertex);
    EXPECT_FALSE(asked.question.choice().resistsBending);
    asked.choose(walled);
    EXPECT_EQ(asked.question.choice().detail.kind, Detail::Kind::EveryVertex);
    EXPECT_TRUE(asked.question.choice().resistsBending);
    asked.detail()->setCurrentIndex(2);
    EXPECT_FALSE(asked.question.choice().resistsBending) << "one stiff piece does not bend";
    asked.detail()->setCurrentIndex(0);
    asked.choose(hollow);
    EXPECT_FALSE(asked.question.choice().resistsBending);
}

TEST(BodyQuestion, AsksHowManyNodesFillASolidBody) {
    AskedBody asked;
    asked.choose(solid);
    EXPECT_EQ(asked.question.choice().detail.kind, Detail::Kind::Filled);
    EXPECT_EQ(asked.question.choice().detail.nodes, 3000U);
    EXPECT_FALSE(asked.detail()->isEnabled());
    EXPECT_FALSE(asked.detail()->toolTip().isEmpty());
    asked.nodes()->setValue(800);
    emit asked.nodes()->valueEdited(800);
    asked.choose(hollow);
    EXPECT_EQ(asked.nodes()->value(), 10000);
    asked.choose(solid);
    EXPECT_EQ(asked.question.choice().detail.nodes, 800U) << "as asked for before";
}

TEST(BodyQuestion, SaysWhatEachCostsBesideTheOthers) {
    AskedBody asked(12000);
    EXPECT_EQ(asked.work(hollow), "1 ×");
    EXPECT_EQ(asked.work(walled), "about 2 ×");
    EXPECT_EQ(asked.work(prisms), "about 9 ×") << "three times the nodes";
    EXPECT_EQ(asked.work(solid), "about 0.4 ×") << "3000 nodes instead of 12 000";
    asked.detail()->setCurrentIndex(1);
    EXPECT_EQ(asked.work(solid), "about 2 ×") << "3000 nodes instead of 2000";
}

TEST(BodyQuestion, DoesNotFillWhatIsOpen) {
    AskedBody asked(10000, false);
    EXPECT_TRUE(asked.question.refusal().isEmpty());
    asked.choose(solid);
    EXPECT_TRUE(asked.question.refusal().contains("open"));
    asked.question.setSurface(10000, true, meanEdge);
    EXPECT_TRUE(asked.question.refusal().isEmpty()) << "it was closed";
    EXPECT_EQ(asked.question.choice().detail.kind, Detail::Kind::Filled) << "and the answer stays";
}

TEST(BodyQuestion, AsksHowThickAWallOfPrismsIs) {
    AskedBody asked(10000, false);
    auto* thickness = asked.question.findChild<NumberField*>("importThickness");
    EXPECT_FALSE(thickness->isEnabled());
    EXPECT_FALSE(thickness->toolTip().isEmpty());
    asked.choose(prisms);
    EXPECT_TRUE(asked.question.refusal().isEmpty()) << "the surface may be open";
    EXPECT_TRUE(thickness->isEnabled());
    EXPECT_FALSE(asked.detail()->isEnabled());
    EXPECT_FALSE(asked.nodes()->isEnabled());
    EXPECT_EQ(asked.nodes()->value(), 30000);
    EXPECT_EQ(asked.question.choice().detail,
              (Detail{Detail::Kind::Filled, 0, LatticeFilling{LatticeKind::Prisms, 0, 0.003, 2}}));
    thickness->setValue(0.01);
    emit thickness->valueEdited(0.01);
    EXPECT_EQ(asked.question.choice().detail.filling, (LatticeFilling{LatticeKind::Prisms, 0, 0.01, 3}));
    EXPECT_EQ(asked.nodes()->value(), 40000) << "a thicker wall has more layers";
    asked.choose(solid);
    EXPECT_EQ(asked.question.choice().detail.nodes, 3000U);
    EXPECT_FALSE(asked.question.choice().detail.filling);
}
