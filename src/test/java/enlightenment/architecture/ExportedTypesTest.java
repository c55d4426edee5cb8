package enlightenment.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.lang.module.ModuleDescriptor;
import java.lang.reflect.Modifier;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** What programs that embed the renderer can see: how much it is, and whether it says what threads may do. */
class ExportedTypesTest {
    private static final Path PROJECT = Path.of(System.getProperty("project.directory", "."));

    /** Types outside of others. A new one needs a reason; fewer are welcome. */
    private static final int MOST = 60;

    private static final Pattern PUBLIC_CLASS =
            Pattern.compile("^public (?:abstract |final |non-sealed )*(?:class|interface) ", Pattern.MULTILINE);

    private static Map<String, List<Class<?>>> exported() throws IOException, ClassNotFoundException {
        Path classes = PROJECT.resolve("target/classes");
        ModuleDescriptor module;
        try (InputStream in = Files.newInputStream(classes.resolve("module-info.class"))) {
            module = ModuleDescriptor.read(in);
        }
        Map<String, List<Class<?>>> types = new TreeMap<>();
        for (ModuleDescriptor.Exports export : module.exports()) {
            List<Class<?>> all = new ArrayList<>();
            try (Stream<Path> files = Files.list(classes.resolve(export.source().replace('.', '/')))) {
                for (Path file : files.sorted().toList()) {
                    String name = file.getFileName().toString();
                    if (name.endsWith(".class") && name.indexOf('$') < 0 && !name.equals("package-info.class")) {
                        String simple = name.substring(0, name.length() - ".class".length());
                        Class<?> type = Class.forName(export.source() + "." + simple, false, loader());
                        if (Modifier.isPublic(type.getModifiers())) {
                            all.add(type);
                        }
                    }
                }
            }
            types.put(export.source(), all);
        }
        return types;
    }

    private static ClassLoader loader() {
        return ExportedTypesTest.class.getClassLoader();
    }

    @Test
    void theNumberOfExportedTypesDoesNotGrow() throws Exception {
        Map<String, List<Class<?>>> types = exported();
        int count = types.values().stream().mapToInt(List::size).sum();
        types.forEach((name, all) -> System.out.println(name + " " + all.size() + ": "
                + all.stream().map(Class::getSimpleName).toList()));
        System.out.println(count + " exported types");
        assertTrue(count <= MOST, count + " exported types");
    }

    @Test
    void everyExportedClassSaysWhatThreadsMayDo() throws Exception {
        List<String> silent = new ArrayList<>();
        for (List<Class<?>> all : exported().values()) {
            for (Class<?> type : all) {
                boolean isValue = type.isRecord() || type.isEnum() || type.isSealed();
                if (!isValue && !Throwable.class.isAssignableFrom(type) && !saysThreads(type)) {
                    silent.add(type.getName());
                }
            }
        }
        // Records, enumerations and sealed families are immutable by the rules of this project.
        assertEquals(List.of(), silent);
    }

    private static boolean saysThreads(Class<?> type) throws IOException {
        String text = Files.readString(
                PROJECT.resolve("src/main/java").resolve(type.getName().replace('.', '/') + ".java"));
        Matcher declared = PUBLIC_CLASS.matcher(text);
        assertTrue(declared.find(), type.getName());
        String before = text.substring(0, declared.start());
        String contract = before.substring(before.lastIndexOf("/**"));
        return contract.contains("thread") || contract.toLowerCase(Locale.ROOT).contains("immutable");
    }
}
