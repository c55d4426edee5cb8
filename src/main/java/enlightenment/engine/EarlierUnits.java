package enlightenment.engine;

import java.util.Optional;
import java.util.OptionalInt;

/** The tiles of a picture with fewer samples, from which those of one with more may go on. */
public final class EarlierUnits {
    private final WorkUnits earlier;
    private final WorkUnits units;

    private EarlierUnits(WorkUnits earlier, WorkUnits units) {
        this.earlier = earlier;
        this.units = units;
    }

    /** The units of an earlier plan of the same picture; empty if it has other tiles, or no fewer samples. */
    public static Optional<EarlierUnits> of(RenderOutline earlier, RenderOutline now) {
        WorkUnits before = WorkUnits.forMachines(earlier.settings(), earlier.plan());
        WorkUnits units = WorkUnits.forMachines(now.settings(), now.plan());
        boolean isUseful =
                earlier.plan().method().word().equals(now.plan().method().word())
                        && earlier.plan().samples() < now.plan().samples()
                        && before.haveTiles()
                        && units.haveTiles()
                        && before.passes() == 1
                        && units.passes() == 1
                        && haveSamePlaces(before, units);
        return isUseful ? Optional.of(new EarlierUnits(before, units)) : Optional.empty();
    }

    private static boolean haveSamePlaces(WorkUnits a, WorkUnits b) {
        int tiles = a.count() - a.batches();
        if (tiles != b.count() - b.batches()) {
            return false;
        }
        for (int tile = 0; tile < tiles; tile++) {
            if (!a.place(a.batches() + tile).equals(b.place(b.batches() + tile))) {
                return false;
            }
        }
        return true;
    }

    /** The number that the tile of this unit had; empty for a unit that is no tile. */
    public OptionalInt of(int unit) {
        return units.isBatch(unit) ? OptionalInt.empty() : OptionalInt.of(earlier.batches() + unit - units.batches());
    }
}
