package enlightenment.render;

import enlightenment.engine.WorkUnits;
import enlightenment.scene.RenderSettings;
import jdk.jfr.Category;
import jdk.jfr.Description;
import jdk.jfr.Event;
import jdk.jfr.Label;
import jdk.jfr.Name;
import jdk.jfr.StackTrace;

/** A unit of work that is done, in Java Flight Recorder. */
@Name("enlightenment.Unit")
@Label("Unit of work")
@Description("One unit of work of a render: a tile, a pass over one, or a batch of paths")
@Category("Enlightenment")
@StackTrace(false)
final class UnitEvent extends Event {
    @Label("Number")
    int unit;

    @Label("First column")
    @Description("0 for a batch of paths")
    int x;

    @Label("First row")
    @Description("0 for a batch of paths")
    int y;

    @Label("Pixels")
    @Description("0 for a batch of paths")
    int pixels;

    /** Ends, as that of this unit. */
    void commit(WorkUnits units, int number) {
        unit = number;
        if (!units.isBatch(number)) {
            RenderSettings.Crop place = units.place(number);
            x = place.x();
            y = place.y();
            pixels = place.width() * place.height();
        }
        commit();
    }
}
