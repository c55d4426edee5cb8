package enlightenment.engine;

import enlightenment.device.share.DeviceTiles;
import enlightenment.film.SampleLog;
import enlightenment.method.TileIntegrator;
import enlightenment.plan.Learned;
import enlightenment.scene.RenderSettings;
import enlightenment.world.CompiledScene;
import enlightenment.world.parts.RayCounters;
import java.nio.ByteBuffer;
import java.util.Objects;
import java.util.function.BooleanSupplier;

/**
 * Makes what does the units of one render, each for one thread.
 *
 * @param units those of the render
 * @param outline of the render
 * @param form of the results
 */
record UnitMakers(WorkUnits units, CompiledScene scene, RenderOutline outline, ResultForm form) {
    private RayCounters counters() {
        return new RayCounters(scene.kindNames.size());
    }

    /** Does units by the processor. */
    UnitMaker maker(BooleanSupplier cancelled) {
        RayCounters counters = counters();
        UnitWork work = work(counters, cancelled, null);
        return unit -> make(unit, work, counters);
    }

    /**
     * Does units by a device.
     *
     * @param tiles of this render's scene; closed with what is returned
     */
    UnitMaker maker(DeviceTiles tiles, BooleanSupplier cancelled) {
        RayCounters counters = counters();
        UnitWork work = work(tiles, counters, cancelled);
        return new UnitMaker() {
            @Override
            public byte[] make(int unit) {
                return UnitMakers.this.make(unit, work, counters);
            }

            @Override
            public void close() {
                tiles.close();
            }
        };
    }

    private byte[] make(int unit, UnitWork work, RayCounters counters) {
        Objects.checkIndex(unit, units.count());
        counters.clear();
        ResultHeader header = new ResultHeader();
        ByteBuffer out = form.make(unit, work, header);
        header.write(out.position(0), counters);
        return out.array();
    }

    /**
     * Does units by the processor, so that more samples can be added.
     *
     * @param log receives the camera samples of each unit; null for none
     */
    GrowingMaker growing(BooleanSupplier cancelled, SampleLog log) {
        RayCounters counters = counters();
        return growing(work(counters, cancelled, log), counters, log);
    }

    /**
     * Does units by a device, so that more samples can be added.
     *
     * @param tiles of this render's scene; not closed
     */
    GrowingMaker growing(DeviceTiles tiles, BooleanSupplier cancelled) {
        RayCounters counters = counters();
        return growing(work(tiles, counters, cancelled), counters, null);
    }

    private GrowingMaker growing(UnitWork work, RayCounters counters, SampleLog log) {
        return new GrowingMaker() {
            @Override
            public boolean canGrow(int unit, byte[] before) {
                return form.canGrow(unit, work, before);
            }

            @Override
            public byte[] make(int unit, byte[] before) {
                counters.clear();
                if (before != null) {
                    counters.add(ResultHeader.counters(before, outline.kinds().size()));
                }
                ResultHeader header = new ResultHeader();
                ByteBuffer out = form.grow(unit, work, header, before);
                header.write(out.position(0), counters);
                if (log != null) {
                    log.flush();
                }
                return out.array();
            }
        };
    }

    /** Whether the method has tiles, and lets more samples be added to their results. */
    boolean methodCanGrow() {
        if (!units.haveTiles()) {
            return false;
        }
        RenderSettings.Crop region = outline.settings().region();
        return work(counters(), () -> false, null).samples(region.x(), region.y()) > 0;
    }

    private UnitWork work(RayCounters counters, BooleanSupplier cancelled, SampleLog log) {
        Learned learned = log == null ? Learned.UNSEEN : new Learned(null, null, log);
        return new UnitWork(units, scene, outline, counters, learned, cancelled);
    }

    private UnitWork work(DeviceTiles tiles, RayCounters counters, BooleanSupplier cancelled) {
        TileIntegrator integrator = tiles.integrator(outline.plan().level(), counters);
        return new UnitWork(units, scene, outline, counters, integrator, cancelled);
    }
}
