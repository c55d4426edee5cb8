package enlightenment.engine;

import java.util.HashMap;
import java.util.Map;

/** Keeps the results of units in memory. */
final class KeptResults implements ResultStore {
    private final Map<Integer, byte[]> results = new HashMap<>();

    @Override
    public void keep(int unit, byte[] bytes) {
        results.put(unit, bytes);
    }

    @Override
    public byte[] get(int unit) {
        return results.get(unit);
    }
}
