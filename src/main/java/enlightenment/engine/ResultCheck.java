package enlightenment.engine;

import enlightenment.file.ContentHash;
import java.util.Objects;
import java.util.Optional;

/** Checks results of a render's units, without the memory of its picture. For use by several threads at once. */
public final class ResultCheck {
    private final WorkUnits units;
    private final ResultForm form;

    private ResultCheck(WorkUnits units, ResultForm form) {
        this.units = units;
        this.form = form;
    }

    /** For the units of a render. */
    public static ResultCheck of(RenderOutline outline) {
        WorkUnits units = WorkUnits.forMachines(outline.settings(), outline.plan());
        return new ResultCheck(units, ResultForm.of(units, outline));
    }

    /** The greatest number of bytes that the result of a unit can have. */
    public int longest(int unit) {
        return form.longest(Objects.checkIndex(unit, units.count()));
    }

    /** Why these bytes cannot be the result of this unit: wrong size, what is no number or out of range; empty if they can. */
    public Optional<String> problem(int unit, byte[] bytes) {
        return form.problemOf(unit, bytes, false);
    }

    /** The hash of a result without problems, as {@link UnitAssembly#digest}. */
    public ContentHash digest(byte[] bytes) {
        return form.digest(bytes);
    }
}
