package enlightenment.engine;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;

/** Orders in which units may come. */
final class UnitOrder {
    private UnitOrder() {}

    /** All units, in an order that the seed decides. */
    static List<Integer> shuffled(int units, long seed) {
        List<Integer> order = new ArrayList<>();
        for (int unit = 0; unit < units; unit++) {
            order.add(unit);
        }
        Collections.shuffle(order, new Random(seed));
        return order;
    }
}
