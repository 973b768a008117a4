//! A program that ends itself while it writes; in a process of its own, which can write nothing afterwards.

use std::fs;
use std::io::Write;
use tomolith_core::Error;
use tomolith_io::{give_up, write_folder_whole, write_whole};

#[test]
fn who_gives_up_leaves_what_was_there_and_nothing_half_written() {
    let folder = tempfile::tempdir().unwrap();
    let [file, frames] = ["a.txt", "frames"].map(|name| folder.path().join(name));
    write_whole(&file, |f| Ok(f.write_all(b"old")?)).unwrap();
    write_folder_whole(&frames, |f| Ok(fs::write(f.join("old"), "old")?)).unwrap();
    let names = || {
        let entries = fs::read_dir(folder.path()).unwrap();
        let mut names: Vec<_> = entries.map(|e| e.unwrap().file_name()).collect();
        names.sort();
        names
    };
    let failed = write_folder_whole(&frames, |new| {
        fs::write(new.join("new"), "new")?;
        let failed = write_whole(&file, |f| {
            f.write_all(&vec![7; 3 << 20])?;
            assert_eq!(names().len(), 4);
            give_up();
            assert_eq!(names(), ["a.txt", "frames"]);
            Ok(())
        });
        assert!(matches!(failed, Err(Error::Io { .. })));
        Ok(())
    });
    assert!(matches!(failed, Err(Error::Io { .. })));
    assert_eq!(names(), ["a.txt", "frames"]);
    assert_eq!(fs::read(&file).unwrap(), b"old");
    assert!(frames.join("old").exists());
    assert!(matches!(
        write_whole(&file, |_| Ok(())),
        Err(Error::Canceled)
    ));
}
