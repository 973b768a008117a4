//! The command as it is typed: its folders, files and exit codes. One program, so that it is linked once.

mod bad_input;
mod begin;
mod bench;
mod commands;
mod devices;
mod files;
mod pages;
mod planning;
mod printer;
mod ranks;
mod reproduce;
mod run;
mod sweep;
mod view;
