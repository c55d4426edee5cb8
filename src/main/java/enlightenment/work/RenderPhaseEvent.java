package enlightenment.work;

import jdk.jfr.Category;
import jdk.jfr.Description;
import jdk.jfr.Event;
import jdk.jfr.Label;
import jdk.jfr.Name;
import jdk.jfr.StackTrace;

/** A phase of a render, in Java Flight Recorder. */
@Name("enlightenment.RenderPhase")
@Label("Render phase")
@Description("One phase of a render: compile, auxiliary, plan, preview, render or finish")
@Category("Enlightenment")
@StackTrace(false)
final class RenderPhaseEvent extends Event {
    @Label("Phase")
    String phase;
}
