package enlightenment.net.parts;

import enlightenment.device.share.PreparedDevice;
import enlightenment.engine.DividedRender;
import enlightenment.engine.FilmAssembly;
import enlightenment.engine.FilmRoom;
import enlightenment.engine.Rendered;
import enlightenment.file.ContentHash;
import enlightenment.image.Image;
import enlightenment.job.Build;
import enlightenment.net.job.JobContent;
import enlightenment.net.job.PartFile;
import enlightenment.net.job.PictureRoom;
import enlightenment.net.job.Results;
import enlightenment.render.RenderProgress;
import enlightenment.render.RenderRequest;
import enlightenment.render.RenderResult;
import enlightenment.scene.RenderSettings;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.DoubleFunction;
import java.util.stream.IntStream;

/**
 * A render in parts that know nothing of each other: for job arrays of whatever scheduler there is. Part i of n has every
 * n-th tile, so that the parts take about equally long.
 *
 * <p>All methods may be called by several threads at once.
 */
public final class RenderParts {
    private RenderParts() {}

    /**
     * Renders a part and writes its file, whole or not at all.
     *
     * @param request its scene, settings, progress, cancellation and device count
     * @param part which part, 1..parts
     * @param parts how many there are
     * @param text what the picture's file is to say of itself, by the number of samples per pixel that is planned; kept in the part
     * @return whether the part is complete: false where it was cancelled
     * @throws IOException if the file cannot be written, or holds another part; the message names it
     * @throws IllegalArgumentException if the part's number is out of range
     * @throws java.util.concurrent.CancellationException if it is cancelled before the render is planned: there is no file then
     */
    public static boolean render(
            RenderRequest request, int part, int parts, DoubleFunction<Map<String, String>> text, Path file)
            throws IOException {
        if (part < 1 || part > parts) {
            throw new IllegalArgumentException("there is no part " + part + " of " + parts);
        }
        RenderSettings settings = request.settings();
        if (settings.budget().seconds().isPresent()) {
            throw new IllegalArgumentException("parts of a render must not depend on the time that they take");
        }
        DividedRender render = DividedRender.preparePart(request.scene(), settings, request.cancelled());
        render.notes().forEach(request.progress()::note);
        ContentHash job =
                JobContent.of(request.scene(), render.outline(), Build.number()).hash();
        requireSamePart(file, part, parts);
        int[] tiles = IntStream.range(0, render.units())
                .filter(tile -> tile % parts == part - 1)
                .toArray();
        PartFile.Head head = new PartFile.Head(
                job, render.outline(), text.apply(render.plan().samples()), part, parts);
        Path folder = file.toAbsolutePath().getParent();
        try (PartResults results = new PartResults(tiles, folder)) {
            make(request, render, tiles, results, PictureRoom.of(Optional.of(RenderRequest.ScratchFolder.of(folder))));
            PartFile.write(file, head, results.units(), results::get);
            return results.made() == tiles.length;
        } catch (UncheckedIOException e) {
            throw e.getCause();
        }
    }

    /** Refuses to replace another part's file, whose name may lack a number by mistake. */
    private static void requireSamePart(Path file, int part, int parts) throws IOException {
        PartFile.Head there = headOf(file);
        if (there != null && !(there.part() == part && there.parts() == parts)) {
            throw new IOException(file + ": holds part " + there.part() + " of " + there.parts()
                    + ", and would be replaced by part " + part + " of " + parts
                    + ": name another file, or remove this one");
        }
    }

    /** Null if there is no file, or none that is a part. */
    private static PartFile.Head headOf(Path file) {
        if (!Files.isRegularFile(file)) {
            return null;
        }
        try (PartFile known = PartFile.open(file)) {
            return known.head();
        } catch (IOException e) {
            // A file of another kind or version is replaced as every output is.
            return null;
        }
    }

    private static void make(
            RenderRequest request, DividedRender render, int[] tiles, PartResults results, FilmRoom room) {
        RenderProgress progress = request.progress();
        RenderSettings.Crop region = render.outline().settings().region();
        long pixels = (long) region.width() * region.height() * tiles.length / render.units();
        try (PreparedDevice device = render.prepare(request.device(), progress::note)) {
            render.make(tiles, device.tiles(), request.cancelled(), (tile, bytes) -> {
                results.keep(tile, bytes);
                synchronized (progress) {
                    progress.progress(
                            (long) ((double) pixels * results.made() / tiles.length),
                            pixels,
                            () -> picture(render, results, room));
                }
            });
            device.note();
        }
    }

    /** The part so far, made of its results: hardly anybody looks, and others need no memory for it. */
    private static Image picture(DividedRender render, PartResults results, FilmRoom room) {
        FilmAssembly film = new FilmAssembly(render.outline(), room);
        try {
            for (int unit : results.units()) {
                film.put(unit, results.get(unit));
            }
            return film.image();
        } finally {
            film.film().release();
        }
    }

    /**
     * The picture that parts make together.
     *
     * @param result the picture and its report; its counts are those of a render at once
     * @param text the texts for the picture's file
     * @param missing the missing parts, in words; empty if there are none
     */
    public record Merged(RenderResult result, Map<String, String> text, List<String> missing) {}

    /**
     * Puts parts together. The same tile may be in several files, if it is the same there.
     *
     * @param scratch where the picture is if it is too large for the memory; empty if it is refused
     * @throws IOException if a file cannot be read or is damaged, or files do not go together; the message names it
     */
    public static Merged merge(List<Path> files, Optional<RenderRequest.ScratchFolder> scratch) throws IOException {
        PartFile.Head first = null;
        FilmAssembly film = null;
        ContentHash[] hashes = null;
        Path[] from = null;
        for (Path file : files) {
            try (PartFile part = PartFile.open(file)) {
                if (first == null) {
                    first = part.head();
                    film = part.assembly(PictureRoom.of(scratch));
                    hashes = new ContentHash[film.units()];
                    from = new Path[film.units()];
                }
                checkSame(files.get(0), first, file, part.head());
                add(part, film, hashes, from);
            }
        }
        if (first == null) {
            throw new IOException("there are no parts to merge");
        }
        Rendered rendered = film.result();
        film.film().release();
        return new Merged(Results.of(rendered), first.text(), missing(first, film));
    }

    private static void add(PartFile part, FilmAssembly film, ContentHash[] hashes, Path[] from) throws IOException {
        for (PartFile.Tile t = part.next(film); t != null; t = part.next(film)) {
            int tile = t.tile();
            ContentHash hash = film.digest(tile, t.bytes());
            if (hashes[tile] != null && !hashes[tile].equals(hash)) {
                throw new IOException(part.file() + ": tile " + tile + " differs from that in " + from[tile]
                        + "; one of the machines computes wrongly");
            }
            if (hashes[tile] == null) {
                film.put(tile, t.bytes());
                hashes[tile] = hash;
                from[tile] = part.file();
            }
        }
    }

    private static void checkSame(Path first, PartFile.Head a, Path file, PartFile.Head b) throws IOException {
        if (a.job().equals(b.job()) && !a.outline().equals(b.outline())) {
            throw new IOException(file + ": tells of its picture otherwise than " + first + "; one of them is damaged");
        }
        if (!a.job().equals(b.job()) || !a.text().equals(b.text())) {
            throw new IOException(file + ": is a part of another picture than " + first + " (" + b.text()
                    + " instead of " + a.text() + (a.text().equals(b.text()) ? "; the scenes differ" : "") + ")");
        }
    }

    private static List<String> missing(PartFile.Head head, FilmAssembly film) {
        TreeMap<Integer, Integer> missing = new TreeMap<>();
        TreeSet<Integer> whole = new TreeSet<>();
        for (int tile = 0; tile < film.units(); tile++) {
            int part = tile % head.parts() + 1;
            if (film.has(tile)) {
                whole.add(part);
            } else {
                missing.merge(part, 1, Integer::sum);
            }
        }
        List<String> words = new ArrayList<>();
        missing.forEach((part, tiles) ->
                words.add((whole.contains(part) ? tiles + " tiles of part " : "part ") + part + "/" + head.parts()));
        return words;
    }
}
