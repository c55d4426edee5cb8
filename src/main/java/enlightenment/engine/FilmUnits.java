package enlightenment.engine;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.BooleanSupplier;
import java.util.function.IntFunction;

/**
 * The units of a film's frames in one row. A frame is compiled when the first unit of it is made, and the last few are kept: threads
 * that go through the units in order compile each frame once. For use by several threads at once.
 */
public final class FilmUnits implements UnitSource {
    /** Threads are in one frame as a rule, and in two where it ends; a third is for one that comes late. */
    private static final int KEPT = 3;

    private final FrameLayout layout;
    private final IntFunction<DividedRender> frames;
    private final int[] groups;

    /** By their numbers, in the order of their last use. */
    private final Map<Integer, DividedRender> latest = new LinkedHashMap<>();

    /**
     * Units of frames.
     *
     * @param groups of each frame, how many units of its render are one of the film
     * @param frames compiles a frame; its groups must be as many as the layout says
     */
    public FilmUnits(FrameLayout layout, int[] groups, IntFunction<DividedRender> frames) {
        this.layout = layout;
        this.groups = groups.clone();
        this.frames = frames;
    }

    @Override
    public int units() {
        return layout.units();
    }

    @Override
    public UnitMaker maker(BooleanSupplier cancelled) {
        return new Maker(cancelled);
    }

    private synchronized DividedRender render(int frame) {
        DividedRender render = latest.remove(frame);
        if (render == null) {
            render = frames.apply(frame);
            if (groups(frame, render).count() != layout.first(frame + 1) - layout.first(frame)) {
                throw new IllegalStateException("a frame has another number of tiles here");
            }
        }
        latest.put(frame, render);
        if (latest.size() > KEPT) {
            latest.remove(latest.keySet().iterator().next());
        }
        return render;
    }

    private UnitGroups groups(int frame, DividedRender render) {
        return UnitGroups.of(render.outline(), groups[frame]);
    }

    /** One thread's, with what it has of the frame that it made a unit of last. */
    private final class Maker implements UnitMaker {
        private final BooleanSupplier cancelled;
        private int frame = -1;
        private UnitMaker ofFrame;

        Maker(BooleanSupplier cancelled) {
            this.cancelled = cancelled;
        }

        @Override
        public byte[] make(int unit) {
            int wanted = layout.frame(unit);
            if (wanted != frame) {
                DividedRender render = render(wanted);
                ofFrame = groups(wanted, render).maker(render.maker(cancelled));
                frame = wanted;
            }
            return ofFrame.make(unit - layout.first(wanted));
        }
    }
}
