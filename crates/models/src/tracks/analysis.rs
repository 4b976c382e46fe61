//! The whole analysis of a recording.

use super::measures::Moment;
use super::{
    Choices, ChoicesError, FrameMeasures, Gap, GroupState, Motion, NullModels, PositionsUsed, Sample, Tracks, Vector,
    gaps, null_models,
};
use arithmetic::{Cancelled, Progress};

/// Why a frame is not in what needs the headings of all fish, or of as many as are asked for: the first reason that holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reason {
    /// Too few fish are there.
    Missing,
    /// Enough are there, but the windows of too many meet a gap or an end of the recording.
    Window,
    /// Enough have a velocity, but too many are at rest.
    AtRest,
}

impl Reason {
    /// As in `frames.csv` and the summary.
    pub fn name(self) -> &'static str {
        match self {
            Reason::Missing => "missing",
            Reason::Window => "window",
            Reason::AtRest => "at_rest",
        }
    }
}

/// Why frames are not in what needs the headings of all fish, or of as many as are asked for; a frame counts once, at the first reason.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct LeftOut {
    /// Frames from the first to the last.
    pub recorded: u64,
    /// Too few fish are there.
    pub missing: u64,
    /// Enough are there, but the windows of too many meet a gap or an end of the recording.
    pub window: u64,
    /// Enough have a velocity, but too many are at rest.
    pub still: u64,
    /// Frames that are used.
    pub used: u64,
    /// Members of all their groups together.
    pub members: u64,
}

/// What is said of one fish.
#[derive(Debug, Clone, PartialEq)]
pub struct FishSummary {
    /// Frames with a position in the recording, not on a bridge.
    pub seen: u64,
    /// Frames without a position, and the number of gaps they form.
    pub missing: (u64, usize),
    /// Frames at rest, without a heading.
    pub still: u64,
    /// Mean speed in units of the file per second, over the frames with a velocity.
    pub speed: Option<f64>,
    /// Mean distance to the nearest neighbour in units of the file, over the frames with enough fish.
    pub distance: Option<f64>,
    /// Shares of frames with a neighbour in the zones of repulsion, orientation and attraction.
    pub zones: Option<[f64; 3]>,
    /// Over how many frames the speed, the distance and the shares go.
    pub over: [u64; 3],
}

/// A recording with everything that was measured.
#[derive(Debug, Clone)]
pub struct Analysis {
    /// The choices it rests on.
    pub choices: Choices,
    /// Where fish are missing.
    pub gaps: Vec<Gap>,
    /// Velocities and headings.
    pub motion: Motion,
    /// The positions used for networks and distances, `[fish][frame]`.
    pub positions: Vec<Vec<Option<Vector>>>,
    /// A record for each frame of the recording that has a row.
    pub frames: Vec<FrameMeasures>,
    /// What was left out.
    pub left_out: LeftOut,
    /// A summary for each fish.
    pub fish: Vec<FishSummary>,
}

/// Measures a recording. Work that `progress` stops gives the analysis of the frames that were reached, that of [`Tracks::first`] with
/// headings that know what came after: then [`Analysis::frames`] are fewer than those of the recording.
///
/// # Errors
/// [`ChoicesError`]; also where no frame has a heading of every fish, and where the work was stopped before there was one.
pub fn analyse(tracks: &Tracks, choices: &Choices, progress: &dyn Progress) -> Result<Analysis, ChoicesError> {
    choices.check(tracks.fish())?;
    if !tracks.is_whole() {
        return Err(ChoicesError::Recording { fish: tracks.fish(), frames: tracks.frames.len() });
    }
    progress.checkpoint()?;
    let mut motion = Motion::new(tracks, choices.smoothing, choices.window, choices.still);
    let mut positions = match choices.positions {
        PositionsUsed::File => tracks.positions.clone(),
        PositionsUsed::Smoothed => motion.smoothed.clone(),
    };
    let of_frame = |rows: &'_ [Vec<Option<Vector>>], i: usize| -> Vec<Option<Vector>> {
        rows.iter().map(|row| row[i].clone()).collect()
    };
    let mut frames = Vec::with_capacity(tracks.frames.len());
    for (i, frame) in tracks.frames.iter().enumerate() {
        if progress.is_cancelled() {
            break;
        }
        progress.tell("frames", i as u64, Some(tracks.frames.len() as u64));
        let (r, v, z) = (of_frame(&positions, i), of_frame(&motion.velocities, i), of_frame(&motion.headings, i));
        let moment = Moment {
            time: frame.time,
            positions: r.iter().map(Option::as_ref).collect(),
            velocities: v.iter().map(Option::as_ref).collect(),
            headings: z.iter().map(Option::as_ref).collect(),
        };
        let measured = FrameMeasures::new(&moment, choices);
        frames.push(measured.map_err(|error| ChoicesError::NothingLeft(format!("t = {}: {error}", frame.time)))?);
    }
    let stopped = frames.len() < tracks.frames.len();
    let reached = stopped.then(|| tracks.first(frames.len()));
    let tracks = reached.as_ref().unwrap_or(tracks);
    for rows in [&mut motion.smoothed, &mut motion.velocities, &mut motion.headings, &mut positions] {
        rows.iter_mut().for_each(|row| row.truncate(frames.len()));
    }
    let gaps = gaps(tracks);
    let mut analysis = Analysis {
        choices: choices.clone(),
        gaps,
        motion,
        positions,
        frames,
        left_out: LeftOut::default(),
        fish: vec![],
    };
    analysis.left_out = analysis.count_left_out(tracks);
    analysis.fish = (0..tracks.fish()).map(|k| analysis.summary_of(tracks, k)).collect();
    if analysis.left_out.used == 0 {
        if stopped {
            return Err(Cancelled.into());
        }
        return Err(ChoicesError::NothingLeft(analysis.why_nothing_is_left(tracks)));
    }
    Ok(analysis)
}

impl Analysis {
    /// The frames with headings of all fish, or of as many as are asked for.
    pub fn groups(&self) -> impl Iterator<Item = (f64, &GroupState)> {
        self.frames.iter().filter_map(|frame| Some((frame.time, frame.group.as_ref()?)))
    }

    /// The mean of a number over the frames of [`Analysis::groups`], of which there is at least one.
    pub fn mean(&self, of: impl Fn(&GroupState) -> f64) -> f64 {
        self.groups().map(|(_, group)| of(group)).sum::<f64>() / self.left_out.used as f64
    }

    /// The mean over the frames of [`Analysis::groups`] of the mean distance to the nearest neighbour, in the unit of the file.
    pub fn mean_nearest(&self) -> Option<f64> {
        mean(self.frames.iter().filter(|frame| frame.group.is_some()).filter_map(FrameMeasures::mean_distance)).0
    }

    /// Frames with headings of all fish: those that null models can use.
    pub fn whole_frames(&self) -> usize {
        self.groups().filter(|(_, group)| group.members.len() == self.fish.len()).count()
    }

    /// All speeds, of all fish and frames that have one.
    pub fn speeds(&self) -> impl Iterator<Item = f64> + '_ {
        self.motion.velocities.iter().flatten().flatten().map(|v| v.norm_squared().sqrt())
    }

    /// All distances to nearest neighbours.
    pub fn distances(&self) -> impl Iterator<Item = f64> + '_ {
        self.frames.iter().flat_map(|frame| &frame.distances).flatten().copied()
    }

    /// Positions and headings of the frames with headings of all fish, for the null models.
    pub fn sample(&self) -> Sample {
        let whole = |group: &GroupState| group.members.len() == self.fish.len();
        let used: Vec<usize> =
            (0..self.frames.len()).filter(|&i| self.frames[i].group.as_ref().is_some_and(whole)).collect();
        let of = |rows: &[Vec<Option<Vector>>]| -> Vec<Vec<Vector>> {
            used.iter().map(|&i| rows.iter().filter_map(|row| row[i].clone()).collect()).collect()
        };
        Sample::new(of(&self.positions), of(&self.motion.headings), &self.choices)
    }

    /// The recording against all null models; `None` where no frame has a heading of every fish.
    ///
    /// # Errors
    /// [`Cancelled`].
    pub fn null_models(
        &self,
        shifts: usize,
        seed: &str,
        progress: &dyn Progress,
    ) -> Result<Option<NullModels>, Cancelled> {
        let sample = self.sample();
        (sample.frames() > 0).then(|| null_models(&sample, shifts, seed, progress)).transpose()
    }

    /// Why a frame of the recording is left out; `None` where it is used.
    pub fn left_out_for(&self, tracks: &Tracks, frame: usize) -> Option<Reason> {
        let least = self.choices.least_fish(tracks.fish());
        let measures = self.frames.get(frame)?;
        let seen = tracks.positions.iter().filter(|places| places[frame].is_some()).count();
        match measures.group {
            Some(_) => None,
            None if seen < least => Some(Reason::Missing),
            None if measures.moving.min(measures.seen) >= least => Some(Reason::AtRest),
            None => Some(Reason::Window),
        }
    }

    fn count_left_out(&self, tracks: &Tracks) -> LeftOut {
        let mut counts = LeftOut { recorded: tracks.recorded_frames(), ..LeftOut::default() };
        counts.missing = counts.recorded - tracks.frames.len() as u64;
        counts.members = self.groups().map(|(_, group)| group.members.len() as u64).sum();
        for i in 0..self.frames.len() {
            *match self.left_out_for(tracks, i) {
                None => &mut counts.used,
                Some(Reason::Missing) => &mut counts.missing,
                Some(Reason::Window) => &mut counts.window,
                Some(Reason::AtRest) => &mut counts.still,
            } += 1;
        }
        counts
    }

    fn summary_of(&self, tracks: &Tracks, k: usize) -> FishSummary {
        let velocities = &self.motion.velocities[k];
        let presence = |zone: usize| {
            mean(self.frames.iter().filter_map(|frame| frame.zones[k]).map(|zones| f64::from(zones[zone])))
        };
        // Places on bridges were not seen.
        let bridged = || tracks.bridged.iter().filter(move |gap| gap.fish == k);
        let on_bridges: u64 = bridged().map(|gap| gap.frames).sum();
        let seen = tracks.positions[k].iter().flatten().count() as u64 - on_bridges;
        let gaps = self.gaps.iter().filter(|gap| gap.fish == k).count() + bridged().count();
        let moving = velocities.iter().flatten().count();
        let headed = self.motion.headings[k].iter().flatten().count();
        let (speed, speeds) = mean(velocities.iter().flatten().map(|v| v.norm_squared().sqrt()));
        let (distance, distances) = mean(self.frames.iter().filter_map(|frame| frame.distances[k]));
        let [(repulsion, zones), (orientation, _), (attraction, _)] = [0, 1, 2].map(presence);
        FishSummary {
            seen,
            missing: (tracks.recorded_frames() - seen, gaps),
            still: (moving - headed) as u64,
            speed,
            distance,
            zones: repulsion.zip(orientation).zip(attraction).map(|((a, b), c)| [a, b, c]),
            over: [speeds, distances, zones],
        }
    }

    fn why_nothing_is_left(&self, tracks: &Tracks) -> String {
        let LeftOut { recorded, missing, window, still, .. } = self.left_out;
        let (who, too_many) = match self.choices.min_fish {
            None => (format!("all {} fish", tracks.fish()), "a fish is"),
            Some(least) => (format!("{least} of {} fish", tracks.fish()), "too many fish are"),
        };
        let Some(rarest) = (0..tracks.fish()).min_by_key(|&k| self.fish[k].seen) else {
            return "there are no fish in the recording".to_string();
        };
        format!(
            "no frame has a heading of {}: of {recorded} frames, {} missing in {missing}, the window of {} \
             frames meets a gap or an end in {window}, {} at rest in {still}; fish {} is seen least, in {} frames; \
             choose a smaller --window, bridge short gaps with --max-gap, count frames with --min-fish, or choose fish with --ids",
            who, too_many, self.choices.window, too_many, tracks.ids[rarest], self.fish[rarest].seen
        )
    }
}

/// The mean of numbers, `None` of none, and how many they are.
fn mean(values: impl Iterator<Item = f64>) -> (Option<f64>, u64) {
    let (sum, count) = values.fold((0.0, 0u64), |(sum, count), x| (sum + x, count + 1));
    ((count > 0).then(|| sum / count as f64), count)
}
