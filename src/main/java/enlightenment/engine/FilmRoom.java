package enlightenment.engine;

import enlightenment.check.Check;
import enlightenment.file.ScratchFile;
import enlightenment.film.FilmInFile;
import enlightenment.film.SplatFilmInFile;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.work.PictureMemory;
import java.nio.file.Path;
import java.util.Optional;

/**
 * The places that a picture's pixels may have while it is made. These are memory, or a file if they are too large.
 *
 * @param folder of the file; empty if the pixels must be in memory
 * @param memory the most bytes that pixels take in memory where there is a folder, of all pictures together
 * @param pictures the most pictures that there are at once, at least 1
 */
public record FilmRoom(Optional<Path> folder, long memory, int pictures) {
    /** In memory only. */
    public static final FilmRoom MEMORY = new FilmRoom(Optional.empty(), Long.MAX_VALUE);

    /** For one picture. */
    public FilmRoom(Optional<Path> folder, long memory) {
        this(folder, memory, 1);
    }

    /** The most that a written picture takes per pixel. */
    private static final long WRITTEN_BYTES = 3 * Float.BYTES;

    /** Rows of pixels that are in a file may take one half of the memory. */
    private static final int SHARE_OF_ROWS = 2;

    /** This room, for several pictures of about the same size at once. */
    public FilmRoom among(int count) {
        return new FilmRoom(folder, memory, count);
    }

    /** Whether a picture is too large for the memory that it may take. */
    public boolean isExceededBy(PictureMemory picture) {
        return folder.isPresent() && picture.bytes() > memory / pictures;
    }

    /**
     * Checks, before anything is rendered, that there is a {@link #place} for all of the pictures.
     *
     * @throws enlightenment.math.InvalidValueException if there is too little memory, or too little space in the folder
     */
    public void check(PictureMemory picture, Optional<String> wholeInMemory) {
        place(picture, wholeInMemory, pictures);
    }

    /**
     * Decides where the pixels of a picture are, before anything is allocated.
     *
     * @param picture what it takes in memory
     * @param wholeInMemory what needs all of the picture in memory, such as {@code a preview}; empty if nothing does
     * @throws enlightenment.math.InvalidValueException if there is too little memory, or too little space in the folder
     */
    public FilmPlace place(PictureMemory picture, Optional<String> wholeInMemory) {
        return place(picture, wholeInMemory, 1);
    }

    private FilmPlace place(PictureMemory picture, Optional<String> wholeInMemory, int count) {
        if (isExceededBy(picture) && wholeInMemory.isEmpty()) {
            checkFile(picture, count);
            return FilmPlace.in(folder.get());
        }
        picture.check(wholeInMemory
                .map(what -> "; " + what + " needs all of it in memory")
                .orElse(""));
        return FilmPlace.MEMORY;
    }

    /** The method, as {@link #place} wants it, if its pictures are in memory whatever the scene. */
    public static Optional<String> wholeInMemory(Method method) {
        return method.kind() != Method.Kind.TILES ? Optional.of("the method " + method.word()) : Optional.empty();
    }

    private void checkFile(PictureMemory picture, int count) {
        RenderSettings.Crop region = picture.settings().region();
        String name = "a picture of " + region.width() + "x" + region.height() + " pixels needs ";
        long most = Runtime.getRuntime().maxMemory();
        boolean hasSplats = picture.films() == PictureMemory.Films.BOTH;
        long rows = FilmInFile.memory(region.width(), region.height(), picture.isLinear());
        if (hasSplats) {
            rows = 2 * rows + SplatFilmInFile.memory(region.width(), region.height());
        }
        Check.that(
                rows <= most / SHARE_OF_ROWS,
                "size",
                name + SHARE_OF_ROWS * rows + " bytes of memory for some of its rows; at most " + most
                        + " are there (java -Xmx sets the limit)");
        long pixels = (long) region.width() * region.height();
        Check.that(
                !hasSplats || pixels <= Integer.MAX_VALUE,
                "size",
                "a picture that paths from lights add to has at most " + Integer.MAX_VALUE + " pixels, not "
                        + region.width() + "x" + region.height());
        long films = hasSplats
                ? FilmInFile.bytesPerPixelWithSplats(picture.isLinear())
                : FilmInFile.bytesPerPixel(picture.isLinear());
        long needed = count * pixels * (films + WRITTEN_BYTES);
        long usable = ScratchFile.usableSpace(folder.get());
        Check.that(
                needed <= usable,
                "size",
                name + needed + " bytes on the disk, for "
                        + (count == 1 ? "a file in " : "files of up to " + count + " at once in ") + folder.get()
                        + " while it is rendered; only "
                        + usable + " are free");
    }
}
