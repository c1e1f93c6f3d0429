package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.agents.PlatformLink;
    import starlogo.engine;
    import starlogo.geometry.Trigonometry;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.ray.Ray;
    import starlogo.search.AgentTable;
    import starlogo.search.Body;
    import starlogo.search.ListedAgents;

    use namespace engine;

    /**
     * Moves an agent as a game character walks. First it slides along the ground. For this slide, surfaces that are too steep are walls. If
     * a wall stops the agent, it tries the same way a step higher, and goes down again. At the end it goes down to the ground, or falls.
     *
     * @private
     */
    public final class WalkQueries
    {
        // Parts of the extent. CLOSE: the agent stands on ground that is at most this far below it. BEHIND_EDGE: at an edge, the face this far
        // behind the edge is tested. REST: a shorter fall counts as none, and is undone.
        private static const CLOSE:Number = 1e-6;
        private static const BEHIND_EDGE:Number = 1e-4;
        private static const REST:Number = 1e-8;

        // Ground as steep as the limit is not too steep, although its normal has rounding errors. A fraction of the limit's cosine.
        private static const SLOPE_ROUNDING:Number = 1e-9;

        // In the air every surface is a wall, except level floors.
        private static const FLOOR:Number = 1 - 1e-12;

        // A walk that is longer than the agent goes in pieces of the agent's size, because the ground may be even only so far. Endless walks have
        // no more pieces than this.
        private static const MOST_PIECES:int = 64;

        // A walk begins with this many pushes at most.
        private static const MOST_PUSHES:int = 8;

        private static const DEFAULTS:WalkOptions = new WalkOptions();
        private static const DOWN:Vector3D = new Vector3D(0, 0, -1);

        private var _set:QuerySet;
        private var _mover:Mover;

        // The walk: its options, and the cosine of the steepest slope; the number of pieces; the way of a piece, its length, and the place where
        // it begins; how far the agent may come; its largest extent; and the depth of ground that is close.
        private var _options:WalkOptions;
        private var _cosine:Number = 0;
        private var _pieces:int = 1;
        private var _piece:Vector3D = new Vector3D();
        private var _whole:Number = 0;
        private var _start:Vector3D = new Vector3D();
        private var _reach:Number = 0;
        private var _extent:Number = 0;
        private var _close:Number = 0;

        // How the agent is carried: its motion, and its turn in degrees.
        private var _carry:Vector3D = new Vector3D();
        private var _turn:Number = 0;

        // The place that is reached without a step, the places before and after the way down, and a part of the walk.
        private var _plain:Vector3D = new Vector3D();
        private var _above:Vector3D = new Vector3D();
        private var _below:Vector3D = new Vector3D();
        private var _way:Vector3D = new Vector3D();

        // The ground that was found: its row and its normal; and where the ray begins that looks for it behind an edge.
        private var _row:int = -1;
        private var _normal:Vector3D = new Vector3D();
        private var _origin:Vector3D = new Vector3D();

        /** @param questions what questions work with */
        public function WalkQueries(questions:QuerySet)
        {
            _set = questions;
            _mover = questions.moves.mover;
        }

        /** See AgentQueries.walk. */
        public function walk(agent:Agent, dx:Number, dy:Number, options:WalkOptions, out:Footing):Footing
        {
            var size:Number = _set.seen.placeOf(agent).size;
            _options = options || DEFAULTS;
            _cosine = (1 - SLOPE_ROUNDING) * Trigonometry.cosine(_options.slopeDegrees);
            _whole = Math.sqrt(dx * dx + dy * dy);
            _pieces = Math.min(MOST_PIECES, Math.max(1, Math.ceil(_whole / size)));
            var standing:PlatformLink = agent.standing ||= new PlatformLink(agent);
            var platform:int = findPlatform(agent, standing);
            // on the steepest slope the way is this long
            _reach = _whole / _cosine + Math.min(_options.fall, size) / 2 + _carry.length;
            _piece.setTo(dx, dy, 0);
            findNear(agent, 0);
            _piece.setTo(dx / _pieces, dy / _pieces, 0);
            _whole /= _pieces;
            var body:Body = _set.moves.body;
            _start.setTo(body.placement.x, body.placement.y, body.placement.z);
            _extent = 2 * body.largestHalf;
            _close = CLOSE * _extent;
            if (platform >= 0)
            {
                carryWith(platform);
            }
            beginAt(_start, -1);
            var footing:Footing = out || new Footing();
            footing.stands = go(agent, footing);
            _set.moves.put(agent, _mover.at, _turn);
            if (!footing.stands)
            {
                _row = -1;
                _normal.setTo(0, 0, 1);
            }
            var table:AgentTable = _set.seen.table;
            footing.on = _row < 0 ? null : table.list.agents[_row];
            footing.normal.copyFrom(_normal);
            standing.on = null;
            if (_row >= ListedAgents.LISTED)
            {
                standing.read(footing.on, table.bodyOf(_row).placement, table.places.now.revisions[_row]);
            }
            return footing;
        }

        // Returns the row of the agent below if it carries the agent, or -1: if it has moved since the last walk, and the filter does not exclude
        // it. Writes how it carries the agent.
        private function findPlatform(agent:Agent, standing:PlatformLink):int
        {
            var row:int = _options.carried && standing.isValid ? _set.seen.rowOf(standing.on) : -1;
            if (row >= 0 && _set.seen.table.shapes[row] != null)
            {
                _turn = standing.carry(_set.seen.table.bodyOf(row).placement, _carry);
                if ((_turn != 0 || _carry.length > 0) && _set.found.admits(row, agent, _options.filter))
                {
                    return row;
                }
            }
            _carry.setTo(0, 0, 0);
            _turn = 0;
            return -1;
        }

        // Carries the agent with the platform. It slides along others that are in its way, but not into the platform. The platform has moved
        // already, so only the rest of its way, which the agent misses, can lead into it.
        private function carryWith(platform:int):void
        {
            beginAt(_start, platform);
            _mover.slide(_carry);
            if (_mover.fraction < 1 && missesInto(platform))
            {
                _plain.copyFrom(_mover.at);
                _mover.at.copyFrom(_start);
                _mover.goUntilTouch(_carry, Mover.SHORT);
                if (missesInto(platform))
                {
                    _mover.at.copyFrom(_plain);
                }
            }
            _start.copyFrom(_mover.at);
        }

        // Whether the way from where the platform would carry the agent to where it is leads into the platform.
        private function missesInto(platform:int):Boolean
        {
            _above.copyFrom(_start);
            _above.incrementBy(_carry);
            _way.copyFrom(_mover.at);
            _way.decrementBy(_above);
            return _mover.meets(platform, _above, _way);
        }

        // Finds the rows near the walk, and in some distance from these.
        private function findNear(agent:Agent, distance:Number):void
        {
            var up:Number = _pieces * _options.stepHeight;
            var down:Number = _pieces * _options.snap + _options.fall;
            _set.moves.begin(agent, _set.ofMoving(agent), _piece.x, _piece.y, 0, _options.filter, _reach + distance, up, down, _turn);
        }

        // Lets the next motion begin at a place, among all rows but one.
        private function beginAt(place:Vector3D, except:int):void
        {
            _mover.begin(_set.moves.body, _set.moves.near.numbers, 0, _set.moves.near.count, except);
            _mover.at.copyFrom(place);
        }

        // Pushes the agent out of what it overlaps, goes all pieces, and falls if the agent does not stand. Returns whether it stands at the end.
        // Writes how far it was pushed, and which part of the way it has come.
        private function go(agent:Agent, footing:Footing):Boolean
        {
            var stands:Boolean = findGround(_close);
            var pushed:Number = 0;
            if (_mover.isDeep)
            {
                pushed = pushOut(agent);
                stands = findGround(_close);
            }
            // a walk that begins in the air stays there
            var isInAir:Boolean = !stands;
            var at:Vector3D = _mover.at;
            var x:Number = _start.x;
            var y:Number = _start.y;
            for (var i:int = 0; i < _pieces; i++)
            {
                if (i > 0)
                {
                    _start.copyFrom(at);
                    stands = !isInAir && findGround(_close);
                }
                stands = goOn(stands);
            }
            x = at.x - x;
            y = at.y - y;
            footing.pushed = pushed;
            footing.part = _whole > 0 ? Math.min(1, Math.sqrt(x * x + y * y) / (_pieces * _whole)) : 1;
            stands ||= _set.moves.body.shape != null && fall();
            _mover.restoreClearance(false);
            return stands;
        }

        // Pushes the agent out of what it overlaps, the deepest overlap first. A push is a slide, so it leads through nothing else. Returns how far.
        private function pushOut(agent:Agent):Number
        {
            var at:Vector3D = _mover.at;
            at.copyFrom(_start);
            if (!_mover.findDeepest())
            {
                return 0;
            }
            var left:Number = _mover.overlap.sum;
            findNear(agent, left);
            beginAt(_start, -1);
            for (var i:int = 0; i < MOST_PUSHES && left > 0 && _mover.findDeepest(); i++)
            {
                var length:Number = Math.min(left, _mover.overlap.contact.depth);
                left -= length;
                _way.setTo(0, 0, 0);
                _mover.overlap.contact.push(_way, length);
                _mover.slide(_way);
            }
            _way.copyFrom(at);
            _way.decrementBy(_start);
            _start.copyFrom(at);
            return _way.length;
        }

        // Goes a piece of the way, and down to the ground. Returns whether the agent stands at the end.
        private function goOn(stands:Boolean):Boolean
        {
            if (!stands)
            {
                // the fall finds whether it stands
                slide(0, FLOOR);
                return false;
            }
            if (_whole == 0)
            {
                // it stays exactly where it is
                _mover.at.copyFrom(_start);
                return true;
            }
            slide(-(_normal.x * _piece.x + _normal.y * _piece.y) / _normal.z, _cosine);
            if (_mover.metWall)
            {
                _plain.copyFrom(_mover.at);
                if (climb())
                {
                    return true;
                }
                _mover.at.copyFrom(_plain);
            }
            return findGround(_options.snap + _close);
        }

        private function slide(rise:Number, steepest:Number):void
        {
            _way.setTo(_piece.x, _piece.y, rise);
            _mover.slide(_way, steepest, _whole);
        }

        private function goDown(depth:Number):void
        {
            _way.setTo(0, 0, -depth);
            _mover.goUntilTouch(_way, Mover.SHORT);
        }

        // Tries the same way a step higher, and goes down again. Returns whether the agent came farther than without the step, and stands.
        private function climb():Boolean
        {
            _mover.at.copyFrom(_start);
            goDown(-_options.stepHeight);
            var height:Number = _mover.at.z - _start.z;
            if (height <= _close)
            {
                return false;
            }
            slide(0, _cosine);
            var farther:Number = (_mover.at.x - _plain.x) * _piece.x + (_mover.at.y - _plain.y) * _piece.y;
            return farther > _close * _whole && findGround(height + _options.snap + _close);
        }

        // Goes down to the ground if it is no deeper than this depth, and not too steep. Returns whether there is such ground.
        private function findGround(depth:Number):Boolean
        {
            _above.copyFrom(_mover.at);
            goDown(depth);
            if (_mover.contactRow >= 0 && (isWalkable(_mover.contact, _mover.contactRow) || isOnAnother()))
            {
                return true;
            }
            _mover.at.copyFrom(_above);
            return false;
        }

        // Whether the agent, which touches something too steep, touches something else that is not.
        private function isOnAnother():Boolean
        {
            _below.copyFrom(_mover.at);
            slideDown(_close, _extent);
            _mover.at.copyFrom(_below);
            return _mover.floor.normalZ > -1 && isWalkable(_mover.floor, _mover.floorRow);
        }

        private function slideDown(depth:Number, widest:Number):void
        {
            _way.setTo(0, 0, -depth);
            _mover.slide(_way, -2, widest, Math.sqrt(1 - _cosine * _cosine) / _cosine);
        }

        // Falls until something stops the agent, and slides down what is too steep. It falls in pieces that get longer, because rounding
        // errors grow with the length of a motion. If nothing stops an endless fall, it ends where it began. Returns whether the agent stands.
        private function fall():Boolean
        {
            var left:Number = _options.fall;
            _above.copyFrom(_mover.at);
            _mover.contactRow = -1;
            for (var piece:Number = 1; left > 0 && _mover.contactRow < 0; piece *= 2)
            {
                if (_mover.at.z - Math.min(left, piece) < -Agent.LARGEST_COORDINATE)
                {
                    _mover.at.copyFrom(_above);
                    return false;
                }
                goDown(Math.min(left, piece));
                left -= _mover.fraction * Math.min(left, piece);
            }
            if (_mover.contactRow >= 0)
            {
                if (isWalkable(_mover.contact, _mover.contactRow))
                {
                    return true;
                }
                var longest:Number = Math.min(_options.fall, _set.moves.body.placement.size);
                slideDown(Math.min(left, longest), longest / 2);
                if (_above.z - _mover.at.z < REST * _extent)
                {
                    _mover.at.copyFrom(_above);
                }
            }
            // a fall can also end where the ground begins, without being stopped
            return findGround(_close);
        }

        // Whether the surface that stopped the way down is not too steep. At an edge, for example of a step, the face behind the edge
        // decides. But the edge must not be more than a step higher than the agent was at the beginning of the walk, or is now.
        private function isWalkable(contact:ContactPoint, row:int):Boolean
        {
            _row = row;
            _normal.setTo(contact.normalX, contact.normalY, contact.normalZ);
            if (_normal.z >= _cosine)
            {
                return true;
            }
            var body:Body = _set.moves.body;
            var bottom:Number = body.z - body.halfZ - body.placement.z;
            if (contact.z > Math.min(_start.z, _mover.at.z) + bottom + _options.stepHeight + _close)
            {
                return false;
            }
            var across:Number = Math.sqrt(_normal.x * _normal.x + _normal.y * _normal.y);
            var behind:Number = BEHIND_EDGE * _extent;
            // the ray begins outside of all faces that are not too steep
            var above:Number = 2 * behind / _cosine;
            _origin.setTo(contact.x - behind * _normal.x / across, contact.y - behind * _normal.y / across, contact.z + above);
            var ray:Ray = _set.rowRays.ray;
            ray.aim(_origin, DOWN);
            ray.to = 2 * above;
            if (!_set.rowRays.meets(row) || ray.from == 0)
            {
                return false;
            }
            _normal.setTo(ray.normalX, ray.normalY, ray.normalZ);
            return _normal.z >= _cosine;
        }
    }
}
