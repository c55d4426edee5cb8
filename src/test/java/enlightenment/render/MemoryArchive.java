package enlightenment.render;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/** An archive in memory, which may fail. */
final class MemoryArchive implements RenderResult.Archive {
    final List<byte[]> plans = new ArrayList<>();
    final List<Map<Integer, byte[]>> results = new ArrayList<>();

    /** How many results it takes before its disk is full. */
    int room = Integer.MAX_VALUE;

    /** What it says then. */
    String full = "No space left on device";

    /** Whether its disk can no longer be read. */
    boolean isUnreadable;

    /** What happens when time has passed. */
    Runnable whenTicked = () -> {};

    /** How often it was asked for a single result, and had it. */
    int found;

    /** How many results it was given. */
    int given;

    @Override
    public String name() {
        return "memory";
    }

    @Override
    public List<byte[]> plans() {
        return List.copyOf(plans);
    }

    @Override
    public int keep(byte[] plan) {
        for (int i = 0; i < plans.size(); i++) {
            if (Arrays.equals(plans.get(i), plan)) {
                return i;
            }
        }
        plans.add(plan);
        results.add(new TreeMap<>());
        return plans.size() - 1;
    }

    @Override
    public void replay(int plan, Replay to) throws IOException {
        for (Map.Entry<Integer, byte[]> result : results.get(plan).entrySet()) {
            to.result(result.getKey(), result.getValue().clone());
        }
    }

    @Override
    public Optional<byte[]> find(int plan, int unit) throws IOException {
        if (isUnreadable) {
            throw new IOException("Input/output error");
        }
        Optional<byte[]> result = Optional.ofNullable(results.get(plan).get(unit));
        found += result.isPresent() ? 1 : 0;
        return result;
    }

    @Override
    public void keep(int plan, int unit, String worker, byte[] result) throws IOException {
        if (given == room) {
            throw new IOException(full);
        }
        given++;
        results.get(plan).put(unit, result);
    }

    @Override
    public void tick() throws IOException {
        whenTicked.run();
    }

    @Override
    public void remove(int plan, int unit) {
        results.get(plan).remove(unit);
    }

    @Override
    public void close() {}
}
