"""What really arrived at each component, held against what its STATUS says of it.

A STATUS names the last message that it rests on (`last_utime`), so that two of them bound a stretch
of each input exactly, however long messages are under way.
"""

import collections
import dataclasses
import typing

import bus_messages


class Said(typing.NamedTuple):
    """A STATUS, and when it was sent."""
    time: float
    status: object


@dataclasses.dataclass
class Account:
    """Of one input of one component, or the sum of several."""
    lost: int = 0  # messages that the line to the component lost
    not_arrived: int = 0  # numbers that never came: lost, or never made for want of what was lost
    dropped: int = 0  # messages that arrived at the machine and did not get to the program
    missed: int = 0  # numbers that never came, as STATUS says
    rejected: int = 0  # messages that STATUS says were turned down
    restarts: int = 0

    def __add__(self, other):
        return Account(*(a + b for a, b in zip(dataclasses.astuple(self),
                                               dataclasses.astuple(other))))

    @property
    def untold(self):
        """What did not get to the program and is not counted as missed."""
        return self.not_arrived + self.dropped - self.missed

    @property
    def is_right(self):
        """What a full queue drops at the end of a session, no later number of it tells."""
        return 0 <= self.untold <= self.dropped if self.restarts else self.untold == 0


def arrivals(sent, machine):
    """Stamps by channel, with their time, in the order in which they arrived."""
    result = collections.defaultdict(list)
    for message in sent:
        if message.machine != machine:
            for delay in message.fates.get(machine, (0.0,)):
                result[message.channel].append((message.time + delay, message.stamp))
    for arrived in result.values():
        arrived.sort(key=lambda one: one[0])
    return result


def stretch(arrived, before, after, channel):
    """What came behind the last message of one STATUS, up to that of another; and the one's."""
    def place(said):
        utime = getattr(bus_messages.inputs(said.status).get(channel), "last_utime", None)
        for index in range(len(arrived) - 1, -1, -1):
            time, stamp = arrived[index]
            if stamp.utime == utime and time <= said.time:
                return index
        return -1
    first, last = place(before), place(after)
    return arrived[first + 1:last + 1], [arrived[first][1]] if first >= 0 else []


def runs(stamps):
    """The numbers of each stretch of one session."""
    result, session = [], None
    for stamp in stamps:
        if stamp.session != session:
            result.append([])
            session = stamp.session
        result[-1].append(stamp.seq)
    return result


def numbers_not_arrived(arrived, last_before):
    """Between the first and the last number of each stretch of one session: where two sessions take
    turns, nobody can tell what is missing between two stretches."""
    stamps = [stamp for _, stamp in arrived]
    count = 0
    for index, numbers in enumerate(runs(last_before + stamps)):
        first = numbers[0] if index == 0 and last_before else min(numbers)
        count += max(numbers) - first + 1 - len({seq for seq in numbers if seq >= first})
    return count


def settle(sent, machine, before, after):
    """The account of each input of the component on a machine, between two of its STATUS."""
    accounts = {}
    then, now = bus_messages.inputs(before.status), bus_messages.inputs(after.status)
    for channel, arrived in arrivals(sent, machine).items():
        if channel not in now:
            continue
        between, last_before = stretch(arrived, before, after, channel)
        grown = {name: getattr(now[channel], name) - getattr(then.get(channel), name, 0)
                 for name in ("received", "rejected", "missed", "restarts")}
        lost = sum(message.channel == channel and message.fates.get(machine) == ()
                   and before.time < message.time < after.time for message in sent)
        accounts[channel] = Account(lost=lost,
                                    not_arrived=numbers_not_arrived(between, last_before),
                                    dropped=len(between) - grown["received"],
                                    missed=grown["missed"], rejected=grown["rejected"],
                                    restarts=grown["restarts"])
    return accounts
