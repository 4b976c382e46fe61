mod flow;
mod sets;
