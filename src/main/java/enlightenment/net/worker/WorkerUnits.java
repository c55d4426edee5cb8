package enlightenment.net.worker;

import enlightenment.engine.DividedRender;
import enlightenment.engine.FilmUnits;
import enlightenment.engine.FrameLayout;
import enlightenment.engine.SharedImages;
import enlightenment.engine.UnitGroups;
import enlightenment.engine.UnitSource;
import enlightenment.file.ContentHash;
import enlightenment.file.FileFailure;
import enlightenment.net.job.FilmContent;
import enlightenment.net.job.JobContent;
import enlightenment.scene.SceneException;
import enlightenment.scene.json.SceneReader;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** What is to be rendered, from the contents of a job: nothing is read from disks. */
public final class WorkerUnits {
    private final SceneReader.NamedFiles files;
    private final SharedImages images;
    private final String version;
    private final int threads;

    private WorkerUnits(Map<ContentHash, byte[]> images, String version, int threads) {
        Map<String, byte[]> byName = new HashMap<>();
        images.forEach((hash, image) -> byName.put(hash.toString(), image));
        files = new SceneReader.NamedFiles(byName);
        this.images = new SharedImages(file -> byName.get(file.toString()));
        this.version = version;
        this.threads = threads;
    }

    /**
     * The units of a job.
     *
     * @param document the job's document, of a picture or of a film
     * @param images the contents of image files
     * @param tiles how many units the server says that there are
     * @param version of this program
     * @throws IOException if the job cannot be used; the message says why. Of a film's frames only the first is looked at; for the
     *     others makers throw an {@link UncheckedIOException}
     */
    public static UnitSource of(
            byte[] document, Map<ContentHash, byte[]> images, int tiles, String version, int threads)
            throws IOException {
        WorkerUnits units = new WorkerUnits(images, version, threads);
        FilmContent.Pictures job = FilmContent.read(document, tiles, version);
        DividedRender first = units.render(job.frames().get(0));
        return job.isFilm() ? units.film(job.frames()) : first;
    }

    /** The units of a film; makers throw an {@link UncheckedIOException} if a frame cannot be used. */
    public static UnitSource of(
            List<FilmContent.Frame> frames, Map<ContentHash, byte[]> images, String version, int threads) {
        return new WorkerUnits(images, version, threads).film(frames);
    }

    private UnitSource film(List<FilmContent.Frame> frames) {
        FrameLayout layout = new FrameLayout(
                frames.stream().mapToInt(FilmContent.Frame::tiles).toArray());
        int[] groups = frames.stream().mapToInt(FilmContent.Frame::group).toArray();
        return new FilmUnits(layout, groups, frame -> {
            try {
                return render(frames.get(frame));
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        });
    }

    private DividedRender render(FilmContent.Frame frame) throws IOException {
        JobContent.Document read = JobContent.read(frame.document(), files, version, threads);
        try {
            DividedRender render = DividedRender.planned(read.scene(), read.settings(), read.plan(), images);
            int tiles = UnitGroups.of(render.outline(), frame.group()).count();
            if (tiles != frame.tiles()) {
                throw new IOException("the job has " + frame.tiles() + " tiles at the server, " + tiles + " here");
            }
            return render;
        } catch (IllegalArgumentException | SceneException e) {
            throw new IOException("the job cannot be used: " + e.getMessage(), e);
        } catch (RuntimeException e) {
            // Values that each may be, and that no server's plan has together.
            throw new IOException("the job cannot be used: " + FileFailure.told(e), e);
        }
    }
}
