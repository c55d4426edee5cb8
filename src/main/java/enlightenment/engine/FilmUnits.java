package enlightenment.engine;

import enlightenment.device.share.DeviceShare;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
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

    /** Compiled frames by their numbers, in the order of their last use. */
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
        return new Maker(frame -> frame.maker(cancelled));
    }

    @Override
    public UnitMaker maker(DeviceShare device, BooleanSupplier cancelled) {
        return new Maker(frame -> frame.maker(device, cancelled));
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

    /** Does units for one thread, with what it has of the frame of its last unit. */
    private final class Maker implements UnitMaker {
        private final Function<DividedRender, UnitMaker> makers;
        private int frame = -1;

        /** The maker of that frame's units; null before the first. */
        private UnitMaker ofUnits;

        private UnitMaker ofGroups;

        Maker(Function<DividedRender, UnitMaker> makers) {
            this.makers = makers;
        }

        @Override
        public byte[] make(int unit) {
            int wanted = layout.frame(unit);
            if (wanted != frame) {
                close();
                DividedRender render = render(wanted);
                ofUnits = makers.apply(render);
                ofGroups = groups(wanted, render).maker(ofUnits);
                frame = wanted;
            }
            return ofGroups.make(unit - layout.first(wanted));
        }

        @Override
        public void close() {
            if (ofUnits != null) {
                ofUnits.close();
                ofUnits = null;
                frame = -1;
            }
        }
    }
}
