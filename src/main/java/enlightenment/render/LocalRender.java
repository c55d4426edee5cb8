package enlightenment.render;

import enlightenment.classic.cluster.ClusterStatistics;
import enlightenment.device.share.DeviceTiles;
import enlightenment.device.share.PreparedDevice;
import enlightenment.engine.FilmPlace;
import enlightenment.engine.PictureFilm;
import enlightenment.engine.Preview;
import enlightenment.engine.RenderOutline;
import enlightenment.engine.Reports;
import enlightenment.engine.UnitWork;
import enlightenment.engine.WorkUnits;
import enlightenment.film.FilmTile;
import enlightenment.image.Image;
import enlightenment.method.metropolis.ChainStatistics;
import enlightenment.plan.Learned;
import enlightenment.plan.RenderPlan;
import enlightenment.report.RenderReport;
import enlightenment.scene.RenderSettings;
import enlightenment.work.Phases;
import enlightenment.work.Workers;
import enlightenment.world.CompiledScene;
import enlightenment.world.parts.RayCounters;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Iterator;
import java.util.List;
import java.util.function.BooleanSupplier;
import jdk.jfr.FlightRecorder;

/**
 * One render in this process. Threads take units of work from a counter; each is a pure function, so who takes which does not
 * matter.
 */
final class LocalRender implements PictureRender {
    private final CompiledScene scene;
    private final RenderOutline outline;
    private final RenderProgress progress;
    private final BooleanSupplier cancelled;
    private final WorkUnits units;
    private final PictureFilm film;

    /** The picture to show where no pixel is finished yet, or null. */
    private final Preview preview;

    private final List<RayCounters> counters = new ArrayList<>();
    /** Gathers ray clusters, or null. */
    private List<RenderResult.RayCluster> clusters;

    /** Gathers chains, or null. */
    private List<RenderResult.PathChain> chains;

    private final PreparedDevice device;

    private long peakMemory;

    /**
     * A render of which nothing is done yet.
     *
     * @param preview what is shown where nothing is finished yet, or null
     * @param place where the finished pixels are
     * @param device takes part
     */
    LocalRender(
            String sceneName,
            CompiledScene scene,
            RenderSettings settings,
            RenderPlan plan,
            RenderProgress progress,
            BooleanSupplier cancelled,
            Preview preview,
            FilmPlace place,
            PreparedDevice device) {
        this.device = device;
        this.scene = scene;
        this.preview = preview;
        this.progress = progress;
        this.cancelled = cancelled;
        outline = RenderOutline.of(sceneName, scene, settings, plan);
        units = WorkUnits.forThreads(settings, plan);
        film = PictureFilm.of(units, outline, place);
    }

    /** Has ray clusters gathered; to be called before the start. */
    void gatherClusters() {
        clusters = new ArrayList<>();
    }

    /** Has chains gathered; to be called before the start. */
    void gatherChains() {
        chains = new ArrayList<>();
    }

    private Learned learned() {
        return new Learned(clusters == null ? null : this::gather, chains == null ? null : this::gatherChains);
    }

    private void gatherChains(List<ChainStatistics> records) {
        synchronized (chains) {
            for (ChainStatistics record : records) {
                chains.add(RenderResult.PathChain.of(record));
            }
        }
    }

    @Override
    public List<RenderResult.PathChain> chains() {
        if (chains == null) {
            return List.of();
        }
        List<RenderResult.PathChain> sorted = new ArrayList<>(chains);
        sorted.sort(Comparator.comparingInt(RenderResult.PathChain::blockY)
                .thenComparingInt(RenderResult.PathChain::blockX)
                .thenComparingInt(RenderResult.PathChain::group));
        return sorted;
    }

    @Override
    public void run() {
        Iterator<DeviceTiles> tiles = device.tiles().iterator();
        int threads = outline.settings().threads() + device.tiles().size();
        double samples = outline.plan().level();
        Workers.run(threads, units.count(), cancelled, () -> {
            RayCounters mine = new RayCounters(scene.kindNames.size());
            counters.add(mine);
            UnitWork work = tiles.hasNext()
                    ? new UnitWork(units, scene, outline, mine, tiles.next().integrator(samples, mine), cancelled)
                    : new UnitWork(units, scene, outline, mine, learned(), cancelled);
            return unit -> render(unit, work);
        });
        device.note();
    }

    private void render(int unit, UnitWork work) {
        if (FlightRecorder.isInitialized()) {
            UnitEvent event = new UnitEvent();
            event.begin();
            FilmTile finished = film.render(unit, work);
            event.commit(units, unit);
            tell(finished);
        } else {
            tell(film.render(unit, work));
        }
    }

    /** @param finished the tile that is finished now, or null */
    private synchronized void tell(FilmTile finished) {
        Runtime runtime = Runtime.getRuntime();
        peakMemory = Math.max(peakMemory, runtime.totalMemory() - runtime.freeMemory());
        if (preview != null && finished != null) {
            preview.put(finished);
        }
        progress.progress(film.pixelsDone(), film.pixels(), this::shown);
    }

    /** The picture so far for those who look at it. */
    private Image shown() {
        return preview == null || film.isComplete() ? film.shown() : film.completed(preview.image());
    }

    private void gather(List<ClusterStatistics> records) {
        synchronized (clusters) {
            for (ClusterStatistics record : records) {
                clusters.add(RenderResult.RayCluster.of(record, scene.frame));
            }
        }
    }

    @Override
    public List<RenderResult.RayCluster> clusters() {
        if (clusters == null) {
            return List.of();
        }
        List<RenderResult.RayCluster> sorted = new ArrayList<>(clusters);
        sorted.sort(Comparator.comparingInt(RenderResult.RayCluster::y)
                .thenComparingInt(RenderResult.RayCluster::x)
                .thenComparingInt(RenderResult.RayCluster::surface)
                .thenComparingInt(RenderResult.RayCluster::light)
                .thenComparingInt(RenderResult.RayCluster::bounces));
        return sorted;
    }

    @Override
    public PictureFilm film() {
        return film;
    }

    @Override
    public Image image() {
        return keepsPreview() ? shown() : film.image();
    }

    private boolean keepsPreview() {
        return preview != null && preview.isKept();
    }

    @Override
    public long shownPixels() {
        return keepsPreview() ? preview.shownPixels() : film.shownPixels();
    }

    @Override
    public RenderReport report(Phases phases, double rounding, int round) {
        RayCounters all = new RayCounters(scene.kindNames.size());
        for (RayCounters one : counters) {
            all.add(one);
        }
        return Reports.of(outline, film, all, 0, phases, rounding, round, peakMemory);
    }
}
