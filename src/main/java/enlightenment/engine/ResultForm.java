package enlightenment.engine;

import enlightenment.file.ContentHash;
import enlightenment.scene.RenderSettings;
import java.nio.ByteBuffer;
import java.util.Optional;

/** The results of units as bytes, most significant first: a {@link ResultHeader}, then what the kind of unit has to say. */
abstract class ResultForm {
    final WorkUnits units;
    final int kinds;

    /** @param kinds the number of kinds of primitives that are counted */
    ResultForm(WorkUnits units, int kinds) {
        this.units = units;
        this.kinds = kinds;
    }

    /** The form for the units of this render. */
    static ResultForm of(WorkUnits units, RenderOutline outline) {
        int kinds = outline.kinds().size();
        ResultForm tiles = units.passes() > 1
                ? new PassForm(units, kinds, outline.display())
                : new TileForm(units, kinds, outline.display());
        if (units.batches() == 0) {
            return tiles;
        }
        RenderSettings.Crop region = outline.settings().region();
        ResultForm batches = new BatchForm(units, kinds, Math.multiplyExact(region.width(), region.height()));
        return units.haveTiles() ? new MixedForm(units, kinds, batches, tiles) : batches;
    }

    /** The greatest number of bytes that the result of a unit can have. */
    abstract int longest(int unit);

    /** Does a unit; the header is left free. */
    abstract ByteBuffer make(int unit, UnitWork work, ResultHeader header);

    /**
     * Does a unit so that more samples can be added to it later, if it is one of those that can.
     *
     * @param before the result of this with fewer samples, made in the same way; null for none
     * @return the result, which may be longer than {@link #longest} tells
     */
    ByteBuffer grow(int unit, UnitWork work, ResultHeader header, byte[] before) {
        return make(unit, work, header);
    }

    /** Whether {@link #grow} takes over what is in the result of this unit with fewer samples. */
    boolean grows(int unit, UnitWork work, byte[] before) {
        return false;
    }

    /** Why bytes with a header in order cannot be the result of a unit, or one that {@link #grow} made; empty if they can. */
    abstract Optional<String> problem(int unit, byte[] bytes);

    /** Puts a result without problems, which must not be there. */
    abstract void put(PictureFilm film, int unit, byte[] bytes);

    /** Removes a result that is present. */
    abstract void remove(PictureFilm film, int unit, ResultStore store);

    /** Whether taking a result out needs what was put. */
    abstract boolean needsStore();

    /** The hash of a result without problems but for its counters. */
    final ContentHash digest(byte[] bytes) {
        return ResultHeader.digest(bytes, kinds);
    }

    /** The offset behind the header. */
    final int start() {
        return ResultHeader.length(kinds);
    }

    /** Whether {@link #grow} can go on from a result without problems, counters included. */
    final boolean canGrow(int unit, UnitWork work, byte[] before) {
        return ResultHeader.hasRoom(before, kinds, units.count()) && grows(unit, work, before);
    }

    /**
     * Why bytes cannot be the result of a unit; empty if they can.
     *
     * @param mayGrow whether they may be what {@link #grow} made
     */
    final Optional<String> problemOf(int unit, byte[] bytes, boolean mayGrow) {
        if (unit < 0 || unit >= units.count()) {
            return Optional.of("there is no unit " + unit + "; they are 0.." + (units.count() - 1));
        }
        if (!mayGrow && bytes.length > longest(unit)) {
            return Optional.of("it has " + bytes.length + " bytes instead of " + longest(unit));
        }
        Optional<String> header = ResultHeader.problem(bytes, kinds, units.count());
        return header.isPresent() ? header : problem(unit, bytes);
    }
}
