package enlightenment.physical;

import enlightenment.scene.BuiltInMethod;

/** Paths from both ends whose vertices pixels share make the right picture. */
class BidirectionalClusterPartnerTest extends BothWaysPartner {
    BidirectionalClusterPartnerTest() {
        super(BuiltInMethod.BIDIRECTIONAL_CLUSTER, 3);
    }
}
