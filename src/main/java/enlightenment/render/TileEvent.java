package enlightenment.render;

import jdk.jfr.Category;
import jdk.jfr.Description;
import jdk.jfr.Event;
import jdk.jfr.Label;
import jdk.jfr.Name;
import jdk.jfr.StackTrace;

/** A rendered tile, in Java Flight Recorder. */
@Name("enlightenment.Tile")
@Label("Tile")
@Description("One tile of a render")
@Category("Enlightenment")
@StackTrace(false)
final class TileEvent extends Event {
    @Label("First column")
    int x;

    @Label("First row")
    int y;

    @Label("Pixels")
    int pixels;
}
