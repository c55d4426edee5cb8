package enlightenment.render;

import enlightenment.device.share.DeviceTiles;
import enlightenment.device.share.PreparedDevice;
import enlightenment.engine.DividedRender;
import enlightenment.engine.FilmAssembly;
import enlightenment.engine.FilmPlace;
import enlightenment.engine.GrowingMaker;
import enlightenment.engine.PictureFilm;
import enlightenment.engine.Preview;
import enlightenment.image.Image;
import enlightenment.plan.RenderPlan;
import enlightenment.report.RenderReport;
import enlightenment.scene.RenderSettings;
import enlightenment.work.Phases;
import enlightenment.work.Workers;
import enlightenment.world.CompiledScene;
import java.util.Iterator;
import java.util.function.BooleanSupplier;

/**
 * A render whose units are kept: those that are not yet are done, as bytes, by the threads of this process. The picture is that of
 * {@link LocalRender}, bit for bit.
 */
final class KeptRender implements PictureRender {
    private final DividedRender render;
    private final FilmAssembly assembly;
    private final RenderRequest request;
    private final BooleanSupplier cancelled;
    private final Archives archives;
    private final int round;

    /** The picture to show where no pixel is finished yet, or null. */
    private final Preview preview;

    private final PreparedDevice device;

    /**
     * A render of which nothing is done yet.
     *
     * @param preview what is shown where nothing is finished yet, or null
     * @param place where the finished pixels are
     * @param device takes part; keeps no camera samples
     */
    KeptRender(
            RenderRequest request,
            CompiledScene scene,
            RenderPlan plan,
            Archives archives,
            int round,
            Preview preview,
            FilmPlace place,
            PreparedDevice device) {
        this.device = device;
        this.request = request;
        this.archives = archives;
        this.round = round;
        this.preview = preview;
        cancelled = request.cancelled();
        render = DividedRender.of(request.scene().name(), scene, request.settings(), plan);
        assembly = render.assembly(place);
    }

    @Override
    public void run() {
        RenderSettings settings = request.settings();
        archives.begin(round, render, assembly);
        int[] missing = assembly.missing();
        tell();
        Archives.Ticker ticker = archives.startTicking();
        Iterator<DeviceTiles> tiles = device.tiles().iterator();
        int threads = settings.threads() + device.tiles().size();
        try {
            Workers.run(threads, missing.length, cancelled, () -> {
                Archives.Samples samples = archives.samples(settings.width());
                GrowingMaker maker = tiles.hasNext()
                        ? render.growing(tiles.next(), cancelled)
                        : render.growing(cancelled, samples.log());
                return i -> {
                    int unit = missing[i];
                    samples.beginUnit(unit);
                    // Samples are to be told, all of them: then nothing is taken over.
                    byte[] earlier = samples.log() == null ? archives.earlier(unit, assembly, maker) : null;
                    byte[] result = maker.make(unit, earlier);
                    // First what must not be lost.
                    archives.keep(unit, result);
                    assembly.put(unit, result);
                    tell();
                };
            });
        } finally {
            ticker.close();
        }
        device.note();
    }

    private void tell() {
        synchronized (archives.telling()) {
            if (assembly.done() > 0) {
                request.progress().progress(assembly.pixelsDone(), assembly.pixels(), this::shown);
            }
        }
    }

    /** The picture so far for those who look at it. */
    private Image shown() {
        if (preview == null) {
            return assembly.image();
        }
        Image image = assembly.finished();
        return film().isComplete() ? image : preview.beneath(film(), image);
    }

    private boolean keepsPreview() {
        return preview != null && preview.isKept();
    }

    @Override
    public PictureFilm film() {
        return assembly.film();
    }

    @Override
    public Image image() {
        return keepsPreview() ? shown() : assembly.finished();
    }

    @Override
    public long shownPixels() {
        return keepsPreview() ? Math.max(film().shownPixels(), preview.shownPixels()) : film().shownPixels();
    }

    @Override
    public RenderReport report(Phases phases, double rounding, int number) {
        return assembly.report(phases, rounding, number);
    }
}
