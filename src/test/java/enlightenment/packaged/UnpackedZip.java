package enlightenment.packaged;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Enumeration;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;

/** The application as somebody installs it. */
final class UnpackedZip {
    private UnpackedZip() {}

    /** Unpacks the application into a folder, except for its textures; gives its own folder. */
    static Path into(Path folder) throws IOException {
        try (ZipFile zip = new ZipFile(Packages.ZIP.toFile())) {
            Enumeration<? extends ZipEntry> entries = zip.entries();
            while (entries.hasMoreElements()) {
                ZipEntry entry = entries.nextElement();
                if (entry.isDirectory() || entry.getName().contains("/textures/")) {
                    continue;
                }
                Path file = folder.resolve(entry.getName());
                Files.createDirectories(file.getParent());
                try (InputStream in = zip.getInputStream(entry)) {
                    Files.copy(in, file);
                }
            }
        }
        Path home = folder.resolve("enlightenment-" + Packages.VERSION);
        if (!home.resolve("bin/enlightenment").toFile().setExecutable(true)) {
            throw new IOException("cannot make the launcher executable");
        }
        return home;
    }
}
