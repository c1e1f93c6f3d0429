package starlogo.queries
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.broadphase.Extents;
    import starlogo.broadphase.Points;
    import starlogo.collision.BinCollider;
    import starlogo.engine;
    import starlogo.models.BuiltInModel;
    import starlogo.search.RowList;
    import support.landOf;

    use namespace engine;

    /** Searches in trees of places and of boxes against loops over all of them. */
    public class RowTreeTest
    {
        private static const MOST_ROWS:int = 400;

        private var _random:SeededRandom;
        private var _filter:AgentFilter = AgentFilter.ofBreeds("thirds");
        private var _sizes:Extents;
        private var _places:Points;
        private var _rows:Vector.<int>;
        private var _tree:RowTree;
        private var _seen:QueryWorld;
        private var _found:Collector;
        private var _near:NearSearch = new NearSearch();
        private var _way:SweptBoxSearch = new SweptBoxSearch();

        [Before]
        public function begin():void
        {
            _random = new SeededRandom(811);
            _tree = new RowTree();
            var greatLand:GreatLand = landOf(BuiltInModel.sphere());
            _seen = new QueryWorld(new BinCollider(greatLand));
            _found = new Collector(_seen);
            var agents:Vector.<Agent> = new Vector.<Agent>();
            for (var i:int = 0; i < MOST_ROWS; i++)
            {
                agents.push(new Agent("sphere", i % 3 == 1 ? "thirds" : "others"));
            }
            _seen.update(agents);
        }

        [Test]
        public function findsPlacesAsALoopDoes():void
        {
            var foundSome:int = 0;
            var foundNone:int = 0;
            for (var world:int = 0; world < 120; world++)
            {
                makeWorld(world);
                _tree.build(_rows, _rows.length, _places);
                for (var i:int = 0; i < 30; i++)
                {
                    var message:String = "world " + world + ", " + i;
                    assertNear(message, world, -1, null) ? foundSome++ : foundNone++;
                    assertNear(message + ", some", world, -1, _filter);
                    if (_rows.length > 0)
                    {
                        assertNear(message + ", beside one", world, anyRow(), i % 2 == 0 ? null : _filter);
                        moveOne(world);
                    }
                }
            }
            assertTrue(foundSome + " some, " + foundNone + " none", foundSome > 1000 && foundNone > 300);
        }

        [Test]
        public function findsBoxesAsALoopDoes():void
        {
            var met:int = 0;
            var missed:int = 0;
            for (var world:int = 0; world < 120; world++)
            {
                makeWorld(world);
                _tree.build(_rows, _rows.length, _sizes);
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
            _sizes.grow(RowList.LISTED + MOST_ROWS);
            _places = new Points();
            _places.x = _sizes.x;
            _places.y = _sizes.y;
            _places.z = _sizes.z;
            _rows = new Vector.<int>();
            var count:int = world % 10 == 0 ? world / 10 : _random.integer(1, MOST_ROWS);
            for (var row:int = RowList.LISTED; row < RowList.LISTED + count; row++)
            {
                _sizes.x[row] = coordinate(world);
                _sizes.y[row] = coordinate(world);
                _sizes.z[row] = world % 3 == 0 ? 0 : coordinate(world);
                _sizes.halfX[row] = _sizes.halfY[row] = _random.logBetween(0.01, 10);
                _sizes.halfZ[row] = _random.pick([0, 0.5, 2]);
            }
            for (row = RowList.LISTED + count - 1; row >= RowList.LISTED; row--)
            {
                if (row % 5 > 0 || count < 10)
                {
                    _seen.table.ranks[row] = _rows.length;
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
            var wasStale:Boolean = _tree.movesLeft < 0;
            _tree.move(row);
            assertTrue(_rows.length + " rows are not worn by one move", _tree.movesLeft >= 0 || wasStale || _rows.length < 60);
            if (_tree.movesLeft < 0)
            {
                _tree.build(_rows, _rows.length, _sizes);
            }
        }

        private function assertNear(message:String, world:int, skipped:int, filter:AgentFilter):Boolean
        {
            var x:Number = skipped < 0 ? coordinate(world) : _sizes.x[skipped];
            var y:Number = skipped < 0 ? coordinate(world) : _sizes.y[skipped];
            var z:Number = skipped < 0 ? (world % 3 == 0 ? 0 : coordinate(world)) : _sizes.z[skipped];
            var limit:Number = Math.pow(_random.pick([0, 1, 5, 30, 1e4, Infinity]), 2);
            var near:Array = [];
            for each (var row:int in _rows)
            {
                var toX:Number = _sizes.x[row] - x;
                var toY:Number = _sizes.y[row] - y;
                var toZ:Number = _sizes.z[row] - z;
                var square:Number = toX * toX + toY * toY + toZ * toZ;
                if (square <= limit && row != skipped && (filter == null || filter.admits(_seen.table.agents[row])))
                {
                    near.push({row: row, rank: _seen.table.ranks[row], square: square});
                }
            }
            near.sort(function(a:Object, b:Object):Number
                {
                    return a.square == b.square ? a.rank - b.rank : a.square - b.square;
                });
            for each (var most:int in [Collector.ALL, 1, 2, 10, 150, 0])
            {
                _found.begin(most, limit, null, filter);
                _found.askerRow = skipped;
                _near.find(_tree, x, y, z, _found);
                _found.endSorted();
                assertEquals(message + ": " + most + ", how many", Math.min(most, near.length), _found.count);
                for (var i:int = 0; i < _found.count; i++)
                {
                    assertEquals(message + ": " + most + ", nearest " + i, near[i].row, _found.rows[i]);
                    assertEquals(message + ": " + most + ", distance " + i, near[i].square, _found.keys[i]);
                }
            }
            _found.begin(Collector.NUMBER, limit, null, filter);
            _found.askerRow = skipped;
            _near.find(_tree, x, y, z, _found);
            assertEquals(message + ": count", near.length, _found.end());
            assertAsked(message, near, x, y, z, limit, filter, skipped);
            return near.length > 0;
        }

        // The function of a filter is called for the nearest rows first, until enough are accepted.
        private function assertAsked(message:String, near:Array, x:Number, y:Number, z:Number, limit:Number, filter:AgentFilter, skipped:int):void
        {
            var asked:Array = [];
            var asking:AgentFilter = new AgentFilter();
            asking.breeds = filter == null ? null : filter.breeds;
            asking.exceptBreeds = filter == null ? null : filter.exceptBreeds;
            asking.except = filter == null ? null : filter.except;
            asking.accepts = function(agent:Agent):Boolean
            {
                asked.push(_seen.table.rowOf(agent));
                return asked.length % 3 == 0;
            };
            for each (var wanted:int in [Collector.ALL, 1, 2, 10])
            {
                asked.length = 0;
                _found.begin(wanted, limit, null, asking);
                _found.askerRow = skipped;
                _near.find(_tree, x, y, z, _found);
                assertEquals(message + ": accepted", Math.min(wanted, int(near.length / 3)), _found.endSorted());
                assertEquals(message + ": asked", wanted > near.length / 3 ? near.length : 3 * wanted, asked.length);
                for (var i:int = 0; i < asked.length; i++)
                {
                    assertEquals(message + ": asked in order", near[i].row, asked[i]);
                    if (i % 3 == 2)
                    {
                        assertEquals(message + ": accepted in order", asked[i], _found.rows[int(i / 3)]);
                    }
                }
            }
        }

        // A box of a size that moves, or stands: returns how many it meets.
        private function assertWay(message:String, world:int, size:Number, moves:Boolean):int
        {
            var from:Array = [coordinate(world), coordinate(world), coordinate(world)];
            var along:Array = [_random.pick([0, 1, _random.between(-1, 1)]), _random.between(-1, 1), _random.pick([0, -1, _random.between(-1, 1)])];
            var limit:Number = moves ? _random.pick([0.5, 10, 1e4, Infinity]) : 0;
            _way.begin(_tree, from[0], from[1], from[2], size, 2 * size, size);
            if (moves)
            {
                _way.moveAlong(along[0], along[1], along[2], limit);
            }
            var times:Vector.<int> = new Vector.<int>(_sizes.x.length);
            var met:int = 0;
            for (var row:int = _way.next(); row != RowList.GROUND; row = _way.next())
            {
                times[row]++;
                met++;
            }
            for each (row in _rows)
            {
                var sizes:Array = [size + _sizes.halfX[row], 2 * size + _sizes.halfY[row], size + _sizes.halfZ[row]];
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
