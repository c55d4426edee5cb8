package enlightenment.engine;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * Consecutive units of a render as one: where units are small, fewer of them are less to talk about. Batches of paths, which come first
 * and are large, stay alone.
 */
public final class UnitGroups {
    private final int units;
    private final int alone;
    private final int size;

    private UnitGroups(int units, int alone, int size) {
        if (units < 1 || size < 1) {
            throw new IllegalArgumentException(units + " units in groups of " + size);
        }
        this.units = units;
        this.alone = alone;
        this.size = size;
    }

    /**
     * The groups of a render's units.
     *
     * @param size of a group; the last one may have fewer
     */
    public static UnitGroups of(RenderOutline outline, int size) {
        WorkUnits all = WorkUnits.forMachines(outline.settings(), outline.plan());
        return new UnitGroups(all.count(), all.batches(), size);
    }

    /** Number of groups. */
    public int count() {
        return alone + (units - alone + size - 1) / size;
    }

    /** The first unit of a group. */
    public int first(int group) {
        Objects.checkIndex(group, count());
        return group < alone ? group : alone + (group - alone) * size;
    }

    /** The unit after the last of a group. */
    public int last(int group) {
        return group < alone ? group + 1 : Math.min(first(group) + size, units);
    }

    /** Makes groups of what makes units: the result of a group has, for each of its units, the length of the result and the result. */
    public UnitMaker maker(UnitMaker ofUnits) {
        return group -> {
            byte[][] results = new byte[last(group) - first(group)][];
            int length = 0;
            for (int i = 0; i < results.length; i++) {
                results[i] = ofUnits.make(first(group) + i);
                length = Math.addExact(length, Integer.BYTES + results[i].length);
            }
            ByteBuffer all = ByteBuffer.allocate(length);
            for (byte[] result : results) {
                all.putInt(result.length).put(result);
            }
            return all.array();
        };
    }

    /** The results of a group's units; empty if these bytes are not what {@link #maker} makes. */
    public Optional<List<byte[]>> split(int group, byte[] bytes) {
        List<byte[]> results = new ArrayList<>();
        ByteBuffer in = ByteBuffer.wrap(bytes);
        for (int unit = first(group); unit < last(group); unit++) {
            int length = in.remaining() < Integer.BYTES ? -1 : in.getInt();
            if (length < 0 || length > in.remaining()) {
                return Optional.empty();
            }
            byte[] result = new byte[length];
            in.get(result);
            results.add(result);
        }
        return in.hasRemaining() ? Optional.empty() : Optional.of(results);
    }
}
