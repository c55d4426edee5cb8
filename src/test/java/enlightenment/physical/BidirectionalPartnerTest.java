package enlightenment.physical;

import enlightenment.scene.BuiltInMethod;

/** Paths from both ends make the right picture. */
class BidirectionalPartnerTest extends BothWaysPartner {
    BidirectionalPartnerTest() {
        super(BuiltInMethod.BIDIRECTIONAL, 2);
    }
}
