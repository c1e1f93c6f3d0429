package starlogo.queries.trees
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.agents.Agent;
    import starlogo.broadphase.Extents;
    import starlogo.collision.BinCollider;
    import starlogo.engine;
    import starlogo.queries.SeenAgents;
    import starlogo.search.table.ListedAgents;

    use namespace engine;

    /** Searches in trees of boxes against loops over all of them. AgentQueriesTest asks trees of places. */
    public class RowTreeTest
    {
        private static const MOST_ROWS:int = 400;

        private var _random:SeededRandom;
        private var _sizes:Extents;
        private var _rows:Vector.<int>;
        private var _tree:RowTree;
        private var _way:SweptBoxSearch = new SweptBoxSearch();
        private var _collector:Collector;

        [Before]
        public function begin():void
        {
            _random = new SeededRandom(811);
            _tree = new RowTree();
            // each row has an agent, so the collector wants it
            var agents:Vector.<Agent> = new Vector.<Agent>();
            for (var i:int = 0; i < MOST_ROWS; i++)
            {
                agents.push(new Agent("sphere"));
            }
            var seen:SeenAgents = new SeenAgents(new BinCollider());
            seen.update(agents);
            _collector = new Collector(seen);
        }

        [Test]
        public function findsBoxesAsALoopDoes():void
        {
            var met:int = 0;
            var missed:int = 0;
            for (var world:int = 0; world < 120; world++)
            {
                makeWorld(world);
                _tree.build(_rows, _rows.length, _sizes, _sizes);
                for (var i:int = 0; i < 30; i++)
                {
                    var count:int = assertWay("world " + world + ", " + i, world, i % 3 == 0 ? 0 : _random.logBetween(0.01, 100), i % 3 < 2);
                    met += count;
                    missed += _rows.length - count;
                    if (_rows.length > 0)
                    {
                        moveOne(world);
                    }
                }
            }
            assertTrue(met + " met, " + missed + " missed", met > 20000 && missed > 100000);
        }

        private function makeWorld(world:int):void
        {
            _sizes = new Extents();
            _sizes.grow(ListedAgents.FIRST_LISTED + MOST_ROWS);
            _rows = new Vector.<int>();
            var count:int = world % 10 == 0 ? world / 10 : _random.integer(1, MOST_ROWS);
            for (var row:int = ListedAgents.FIRST_LISTED; row < ListedAgents.FIRST_LISTED + count; row++)
            {
                _sizes.x[row] = coordinate(world);
                _sizes.y[row] = coordinate(world);
                _sizes.z[row] = world % 3 == 0 ? 0 : coordinate(world);
                _sizes.halfX[row] = _sizes.halfY[row] = _random.logBetween(0.01, 10);
                _sizes.halfZ[row] = _random.pick([0, 0.5, 2]);
            }
            for (row = ListedAgents.FIRST_LISTED + count - 1; row >= ListedAgents.FIRST_LISTED; row--)
            {
                if (row % 5 > 0 || count < 10)
                {
                    _rows.push(row);
                }
            }
        }

        private function anyRow():int
        {
            return _rows[_random.integer(0, _rows.length - 1)];
        }

        // dense; on a grid, so that many are equally far; in one place; far out; over many orders
        private function coordinate(world:int):Number
        {
            switch (world % 6)
            {
                case 0:
                    return _random.between(-20, 20);
                case 1:
                    return _random.integer(-4, 4);
                case 2:
                    return _random.integer(0, 9) < 8 ? 7.25 : _random.between(0, 20);
                case 3:
                    return 1e9 + _random.between(-50, 50);
                case 4:
                    return _random.logBetween(1e-3, 1e6) * _random.pick([-1, 1]);
                default:
                    return _random.integer(0, 19) == 0 ? 1e7 * _random.between(-1, 1) : _random.between(-1, 1);
            }
        }

        private function moveOne(world:int):void
        {
            var row:int = anyRow();
            _sizes.x[row] = coordinate(world);
            _sizes.y[row] = coordinate(world);
            _sizes.z[row] = coordinate(world);
            var wasStale:Boolean = _tree.isStale;
            _tree.enlargeAround(row, _sizes, _sizes);
            assertTrue(_rows.length + " rows are not worn by one move", !_tree.isStale || wasStale || _rows.length < 60);
            if (_tree.isStale)
            {
                _tree.build(_rows, _rows.length, _sizes, _sizes);
            }
        }

        // A box of a size that moves, or stands: returns how many it meets.
        private function assertWay(message:String, world:int, size:Number, moves:Boolean):int
        {
            var from:Array = [coordinate(world), coordinate(world), coordinate(world)];
            var along:Array = [_random.pick([0, 1, _random.between(-1, 1)]), _random.between(-1, 1), _random.pick([0, -1, _random.between(-1, 1)])];
            var limit:Number = moves ? _random.pick([0.5, 10, 1e4, Infinity]) : 0;
            _way.setTo(_tree, new Vector3D(from[0], from[1], from[2]));
            _way.inflate(size, size, size);
            if (moves)
            {
                _way.moveAlong(new Vector3D(along[0], along[1], along[2]));
            }
            var times:Vector.<int> = new Vector.<int>(_sizes.x.length);
            var met:int = 0;
            _collector.begin(Collector.ALL, limit, null, null);
            for (var row:int = _way.next(_collector); row >= 0; row = _way.next(_collector))
            {
                times[row]++;
                met++;
            }
            for each (row in _rows)
            {
                var sizes:Array = [size + _sizes.halfX[row], size + _sizes.halfY[row], 2 * size + _sizes.halfZ[row]];
                var to:Array = [_sizes.x[row] - from[0], _sizes.y[row] - from[1], _sizes.z[row] - from[2]];
                var far:Number = Math.abs(_sizes.x[row]) + Math.abs(_sizes.y[row]) + Math.abs(_sizes.z[row]) + Math.abs(from[0]) + Math.abs(from[1]) + Math.abs(from[2]);
                if (meets(to, sizes, along, limit, 0))
                {
                    assertEquals(message + ": row " + row + " is met", 1, times[row]);
                }
                else if (!meets(to, sizes, along, limit, 1e-12 * (far + size + 10)))
                {
                    assertEquals(message + ": row " + row + " is missed", 0, times[row]);
                }
            }
            return met;
        }

        private static function meets(to:Array, sizes:Array, along:Array, limit:Number, gap:Number):Boolean
        {
            var first:Number = 0;
            var last:Number = limit;
            for (var axis:int = 0; axis < 3; axis++)
            {
                var reach:Number = sizes[axis] + gap;
                if (along[axis] == 0 || limit == 0)
                {
                    if (Math.abs(to[axis]) > reach)
                    {
                        return false;
                    }
                    continue;
                }
                var middle:Number = to[axis] / along[axis];
                var half:Number = Math.abs(reach / along[axis]);
                first = Math.max(first, middle - half);
                last = Math.min(last, middle + half);
            }
            return first <= last;
        }
    }
}
