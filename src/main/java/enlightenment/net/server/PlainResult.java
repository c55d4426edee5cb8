package enlightenment.net.server;

import enlightenment.engine.UnitAssembly;
import java.util.Arrays;

/**
 * A result as workers give it. One that a single process kept may be longer, so that more samples can be added to it: then it would not be
 * taken for the same as theirs.
 */
final class PlainResult {
    private PlainResult() {}

    /** The result of a unit without what it can grow by. */
    static byte[] of(UnitAssembly film, int unit, byte[] result) {
        return unit < film.units() && result.length > film.longest(unit)
                ? Arrays.copyOf(result, film.longest(unit))
                : result;
    }
}
