//! Requests and replies of HTTP/1.1 as far as pages need them: one request for each connection, read within limits of size and time.

use std::io::{self, Read, Write};
use std::net::{Shutdown, TcpStream};
use std::time::{Duration, Instant};

/// Most bytes of the first line and the headers, and most headers.
const HEAD: usize = 16 * 1024;
const HEADERS: usize = 64;
/// How long a request may take to arrive, and a reply to leave.
const PATIENCE: Duration = Duration::from_secs(10);
/// How long what a refused request still sends is thrown away, so that the refusal arrives.
const DRAIN: Duration = Duration::from_millis(500);

/// What was asked.
pub struct Request {
    pub method: String,
    /// The path and what follows it.
    pub target: String,
    headers: Vec<(String, String)>,
    pub body: Vec<u8>,
}

impl Request {
    /// The values of a header, in small letters.
    pub fn values<'a>(&'a self, name: &'a str) -> impl Iterator<Item = String> + 'a {
        self.headers.iter().filter(move |(known, _)| known.eq_ignore_ascii_case(name)).map(|(_, v)| v.to_lowercase())
    }
}

/// Why a request is not answered.
#[derive(Debug, thiserror::Error)]
pub enum RequestError {
    /// Nobody to tell.
    #[error("the connection was lost: {0}")]
    Lost(#[from] io::Error),
    /// A status and what is wrong.
    #[error("{1}")]
    Refused(u16, &'static str),
}

/// Reads a whole request with a body of at most so many bytes.
pub fn read(stream: &mut TcpStream, longest: usize) -> Result<Request, RequestError> {
    let mut input = Input { stream, until: Instant::now() + PATIENCE, bytes: Vec::new() };
    loop {
        if let Some((mut request, head)) = parsed(&input.bytes)? {
            let length = length(&request, longest)?;
            while input.bytes.len() < head + length {
                input.more()?;
            }
            request.body = input.bytes[head..head + length].to_vec();
            return Ok(request);
        }
        if input.bytes.len() > HEAD {
            return Err(RequestError::Refused(431, "the headers are too long"));
        }
        input.more()?;
    }
}

/// The head of a request and its length, once it is there.
fn parsed(bytes: &[u8]) -> Result<Option<(Request, usize)>, RequestError> {
    let mut headers = [httparse::EMPTY_HEADER; HEADERS];
    let mut head = httparse::Request::new(&mut headers);
    let status = head.parse(bytes).map_err(|error| match error {
        httparse::Error::TooManyHeaders => RequestError::Refused(431, "there are too many headers"),
        _ => RequestError::Refused(400, "that is no request of HTTP/1.1"),
    })?;
    let httparse::Status::Complete(length) = status else { return Ok(None) };
    if length > HEAD {
        return Err(RequestError::Refused(431, "the headers are too long"));
    }
    let text = |header: &httparse::Header| {
        let value = std::str::from_utf8(header.value).map_err(|_| RequestError::Refused(400, "a header is no text"))?;
        Ok((header.name.to_string(), value.trim().to_string()))
    };
    let headers = head.headers.iter().map(text).collect::<Result<_, RequestError>>()?;
    let word = |word: Option<&str>| word.unwrap_or_default().to_string();
    Ok(Some((Request { method: word(head.method), target: word(head.path), headers, body: Vec::new() }, length)))
}

/// The length of the body, which is refused before it is read where it is too long.
fn length(request: &Request, longest: usize) -> Result<usize, RequestError> {
    if request.values("Transfer-Encoding").next().is_some() {
        return Err(RequestError::Refused(501, "a body has a Content-Length here"));
    }
    let lengths: Vec<String> = request.values("Content-Length").collect();
    match lengths.as_slice() {
        [] => Ok(0),
        [digits] if !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_digit()) => {
            let length = digits.parse().ok().filter(|length| *length <= longest);
            length.ok_or(RequestError::Refused(413, "the body is too long"))
        }
        _ => Err(RequestError::Refused(400, "the Content-Length is no number")),
    }
}

struct Input<'s> {
    stream: &'s mut TcpStream,
    until: Instant,
    bytes: Vec<u8>,
}

impl Input<'_> {
    /// Waits for further bytes.
    fn more(&mut self) -> Result<(), RequestError> {
        let left = self.until.saturating_duration_since(Instant::now());
        if left.is_zero() {
            return Err(RequestError::Refused(408, "the request took too long to arrive"));
        }
        self.stream.set_read_timeout(Some(left))?;
        let mut part = [0; 8192];
        match self.stream.read(&mut part) {
            Ok(0) => Err(io::Error::from(io::ErrorKind::UnexpectedEof).into()),
            Ok(count) => {
                self.bytes.extend_from_slice(&part[..count]);
                Ok(())
            }
            Err(error) if is_late(&error) || error.kind() == io::ErrorKind::Interrupted => Ok(()),
            Err(error) => Err(error.into()),
        }
    }
}

fn is_late(error: &io::Error) -> bool {
    matches!(error.kind(), io::ErrorKind::WouldBlock | io::ErrorKind::TimedOut)
}

/// What every reply says beside its own kind.
const ALWAYS: &str = "Connection: close\r\nX-Content-Type-Options: nosniff\r\nReferrer-Policy: no-referrer\r\nCache-Control: no-store\r\n\
     Content-Security-Policy: default-src 'self' data: 'unsafe-inline'; frame-ancestors 'none'; form-action 'none'; base-uri 'none'\r\n";

/// A reply on its way.
pub struct Reply<'s> {
    stream: &'s TcpStream,
    /// Whether it has no body.
    bare: bool,
}

impl<'s> Reply<'s> {
    pub fn new(stream: &'s TcpStream, bare: bool) -> Self {
        Reply { stream, bare }
    }

    /// The whole reply at once.
    pub fn whole(&mut self, status: u16, kind: &str, body: &[u8]) -> io::Result<()> {
        self.head(status, kind, Some(body.len()))?;
        if self.bare { Ok(()) } else { self.write(body) }
    }

    /// A refusal in one sentence.
    pub fn refuse(&mut self, status: u16, why: &str) -> io::Result<()> {
        self.whole(status, "text/plain; charset=utf-8", format!("{why}\n").as_bytes())
    }

    /// The beginning of a reply whose parts come as they are found.
    pub fn begin(&mut self, kind: &str) -> io::Result<()> {
        self.head(200, kind, None)
    }

    /// A further part.
    pub fn write(&mut self, part: &[u8]) -> io::Result<()> {
        self.stream.write_all(part)?;
        self.stream.flush()
    }

    /// Whether nobody listens any more.
    pub fn is_closed(&self) -> bool {
        let mut byte = [0];
        let waited = self.stream.set_read_timeout(Some(Duration::from_millis(1)));
        match waited.and_then(|()| self.stream.peek(&mut byte)) {
            Ok(count) => count == 0,
            Err(error) => !is_late(&error),
        }
    }

    /// Ends it, so that it arrives even where more was sent than was read.
    pub fn end(self) {
        let _ = self.stream.shutdown(Shutdown::Write);
        let (until, mut part) = (Instant::now() + DRAIN, [0; 8192]);
        let mut stream = self.stream;
        while Instant::now() < until && stream.set_read_timeout(Some(DRAIN)).is_ok() {
            match stream.read(&mut part) {
                Ok(count) if count > 0 => {}
                _ => break,
            }
        }
    }

    fn head(&mut self, status: u16, kind: &str, length: Option<usize>) -> io::Result<()> {
        self.stream.set_write_timeout(Some(PATIENCE))?;
        let length = length.map_or(String::new(), |length| format!("Content-Length: {length}\r\n"));
        let words = match status {
            200 => "OK",
            403 => "Forbidden",
            404 => "Not Found",
            405 => "Method Not Allowed",
            408 => "Request Timeout",
            413 => "Content Too Large",
            422 => "Unprocessable Content",
            431 => "Request Header Fields Too Large",
            501 => "Not Implemented",
            503 => "Service Unavailable",
            _ => "Bad Request",
        };
        self.write(format!("HTTP/1.1 {status} {words}\r\nContent-Type: {kind}\r\n{length}{ALWAYS}\r\n").as_bytes())
    }
}
