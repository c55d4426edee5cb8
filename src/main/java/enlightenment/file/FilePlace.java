package enlightenment.file;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.text.Normalizer;
import java.util.Locale;

/** Where a path leads, whether or not there is a file yet, and whether two paths lead to one file. */
public final class FilePlace {
    /** More links in a row than this lead in a circle. */
    private static final int MOST_LINKS = 40;

    private FilePlace() {}

    /**
     * The place that writing to the path would change: links are followed, that of the file itself too, and {@code ..} goes
     * where the operating system says. What does not exist is taken as it is spelled.
     *
     * @throws IOException if links lead in a circle or cannot be read
     */
    public static Path of(Path file) throws IOException {
        return of(file.toAbsolutePath(), file, MOST_LINKS);
    }

    private static Path of(Path absolute, Path asked, int linksLeft) throws IOException {
        if (Files.exists(absolute)) {
            return real(absolute);
        }
        if (linksLeft == 0) {
            throw new FileSystemException(asked.toString(), null, "its links lead in a circle");
        }
        Path parent = absolute.getParent();
        if (parent == null) {
            return absolute;
        }
        Path folder = of(parent, asked, linksLeft);
        Path here = folder.resolve(absolute.getFileName());
        return Files.isSymbolicLink(here)
                ? of(folder.resolve(Files.readSymbolicLink(here)), asked, linksLeft - 1)
                : here.normalize();
    }

    private static Path real(Path there) throws IOException {
        try {
            return there.toRealPath();
        } catch (NoSuchFileException e) {
            // A pipe of this process, as /dev/stdout may be, has no other name: what its link says is no path.
            return there;
        }
    }

    /**
     * Whether writing to one path would change what is read at the other. Two files that are not there yet are one if they
     * lie in one folder and its file system takes their names for the same, as some do with capital letters or with accents
     * that are put together from two characters.
     */
    public static boolean same(Path a, Path b) throws IOException {
        Path p = of(a);
        Path q = of(b);
        if (p.equals(q)) {
            return true;
        }
        boolean there = Files.exists(p);
        if (there || Files.exists(q)) {
            return there && Files.exists(q) && Files.isSameFile(p, q);
        }
        Path folder = p.getParent();
        return folder != null && folder.equals(q.getParent()) && sameName(folder, name(p), name(q));
    }

    private static String name(Path place) {
        return place.getFileName().toString();
    }

    private static boolean sameName(Path folder, String a, String b) throws IOException {
        return folded(a).equals(folded(b)) && Files.isWritable(folder) && takesForSame(folder, a, b);
    }

    /** Without what any file system is known to overlook. */
    private static String folded(String name) {
        String apart = Normalizer.normalize(name, Normalizer.Form.NFKD);
        return apart.toUpperCase(Locale.ROOT).toLowerCase(Locale.ROOT);
    }

    /** Tries it, in a folder of its own. */
    private static boolean takesForSame(Path folder, String a, String b) throws IOException {
        try (TemporaryFile temporary = TemporaryFile.in(folder)) {
            Path inner = temporary.folder();
            Files.createFile(inner.resolve(a));
            return Files.exists(inner.resolve(b));
        }
    }
}
