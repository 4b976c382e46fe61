mod flow;
mod sets;
mod twin;
