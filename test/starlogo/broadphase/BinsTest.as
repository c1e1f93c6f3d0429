package starlogo.broadphase
{
    import flash.utils.Dictionary;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import evaluation.pairs.SeededRandom;
    import starlogo.agents.Agent;
    import starlogo.agents.CacheToken;

    /** The bins alone, with rectangles that come from no agent. */
    public class BinsTest
    {
        private var _bins:Bins;
        private var _sink:PairList;
        private var _token:CacheToken;

        [Before]
        public function makeBins():void
        {
            _bins = new Bins();
            _sink = new PairList();
            _token = new CacheToken();
        }

        [Test]
        public function findsThePairsWhoseRectanglesOverlapOnce():void
        {
            var random:SeededRandom = new SeededRandom(501);
            var overlapping:int = 0;
            for (var world:int = 0; world < 60; world++)
            {
                var proxies:Vector.<AgentProxy> = new Vector.<AgentProxy>();
                var spread:Number = random.logBetween(1, 1000);
                for (var i:int = 0; i < 60; i++)
                {
                    proxies.push(proxyAt(random.between(-spread, spread), random.between(-spread, spread),
                                random.logBetween(0.01, 30), random.logBetween(0.01, 30)));
                }
                overlapping += assertLikeBruteForce("world " + world, proxies);
            }
            assertTrue(overlapping + " overlap", overlapping > 1000 && overlapping < 60 * 60 * 59 / 4);
        }

        [Test]
        public function rectanglesThatTouchByRoundingShareABin():void
        {
            // sums of tenths: a's right side and b's left side are one number, but for rounding, on the border of two bins
            var random:SeededRandom = new SeededRandom(502);
            for (var i:int = 0; i < 3000; i++)
            {
                var half:Number = random.integer(1, 40) / 10;
                var border:Number = random.integer(-1000, 1000) * 16;
                var a:AgentProxy = proxyAt(border - half, 0, half, half);
                var b:AgentProxy = proxyAt(border + half, 0, half, half);
                // one up to the border, the other beginning a last bit beyond it
                b.x = (b.x - half) * (1 + 2e-16) + half;
                search(new <AgentProxy>[a, b]);
                assertEquals(half + " at " + border, 1, _sink.length);
            }
        }

        [Test]
        public function whoMovesOutOfItsLevelsReachGetsAnother():void
        {
            var proxy:AgentProxy = proxyAt(0, 0, 0.5, 0.5);
            _bins.fit(proxy);
            var level:BinLevel = proxy.level;
            assertFalse(_bins.isBeyondReach(proxy));
            proxy.x = 1e12;
            assertTrue(_bins.isBeyondReach(proxy));
            _bins.fit(proxy);
            assertTrue("wider bins", proxy.level !== level && proxy.level.width > level.width);
            assertFalse(_bins.isBeyondReach(proxy));
            // far out the columns of the old level would not fit an int
            var other:AgentProxy = proxyAt(1e12, 0.75, 0.5, 0.5);
            _bins.fit(other);
            assertEquals(1, assertLikeBruteForce("far out", new <AgentProxy>[proxy, other]));
        }

        [Test]
        public function levelsAreOfTheSizeOfTheirProxies():void
        {
            var proxy:AgentProxy = proxyAt(3, 4, 0.5, 0.5);
            _bins.fit(proxy);
            assertEquals("unit spheres", 2, proxy.level.width);
            proxy.halfY = 0.51;
            _bins.fit(proxy);
            assertEquals(4, proxy.level.width);
            proxy.halfY = 0.5;
            _bins.fit(proxy);
            assertEquals("and back", 2, proxy.level.width);
            proxy.halfX = proxy.halfY = 0;
            _bins.fit(proxy);
            assertTrue("a point", proxy.level.width > 0 && proxy.level.width < 1e-6);
        }

        [Test]
        public function whoHasLeftIsLetGo():void
        {
            var stay:AgentProxy = proxyAt(0, 0, 0.5, 0.5);
            var aside:AgentProxy = proxyAt(0.2, 0.2, 0.5, 0.5);
            var leave:Vector.<AgentProxy> = new Vector.<AgentProxy>();
            for (var i:int = 0; i < 40; i++)
            {
                leave.push(proxyAt(i % 7 * 0.3, i % 5 * 0.3, i % 3 + 0.1, 0.4));
            }
            search(leave.concat(new <AgentProxy>[stay, aside]));
            assertTrue("the last search may be held", reach(new <AgentProxy>[stay], leave));
            search(new <AgentProxy>[stay]);
            assertFalse("neither by who stays nor by who just isn't there", reach(new <AgentProxy>[stay, aside], leave));
            search(new Vector.<AgentProxy>());
            assertFalse(reach(new <AgentProxy>[leave[3]], new <AgentProxy>[stay]));
        }

        [Test]
        public function aSearchThatWasNotFinishedHoldsNobody():void
        {
            var stay:AgentProxy = proxyAt(0, 0, 0.5, 0.5);
            var leave:AgentProxy = proxyAt(0.1, 0, 0.5, 0.5);
            search(new <AgentProxy>[leave, stay]);
            fill(new <AgentProxy>[leave, stay]);
            search(new <AgentProxy>[stay]);
            assertFalse(reach(new <AgentProxy>[stay], new <AgentProxy>[leave]));
        }

        [Test]
        public function proxiesMayChangeLevelsWhileOthersLeave():void
        {
            var random:SeededRandom = new SeededRandom(503);
            var proxies:Vector.<AgentProxy> = new Vector.<AgentProxy>();
            for (var i:int = 0; i < 50; i++)
            {
                proxies.push(proxyAt(random.between(0, 8), random.between(0, 8), 0.5, 0.5));
            }
            var overlapping:int = 0;
            for (var k:int = 0; k < 30; k++)
            {
                proxies.splice(random.integer(0, proxies.length - 1), 1);
                for each (var proxy:AgentProxy in proxies)
                {
                    proxy.halfX = random.pick([0.2, 0.5, 1, 3]);
                }
                overlapping += assertLikeBruteForce("search " + k, proxies);
            }
            assertTrue(overlapping > 500);
        }

        [Test]
        public function aSinkThatThrowsLeavesTheNextSearchAsItShouldBe():void
        {
            var proxies:Vector.<AgentProxy> = new <AgentProxy>[proxyAt(0, 0, 1, 1), proxyAt(0.5, 0, 1, 1), proxyAt(0.5, 0.5, 4, 1)];
            var thrown:Boolean = false;
            try
            {
                fill(proxies);
                _bins.findPairs(new PairSink());
            }
            catch (error:Error)
            {
                thrown = true;
            }
            assertTrue(thrown);
            assertEquals(3, assertLikeBruteForce("afterwards", proxies));
        }

        private function proxyAt(x:Number, y:Number, halfX:Number, halfY:Number):AgentProxy
        {
            var proxy:AgentProxy = new AgentProxy(new Agent("sphere"), _token);
            proxy.x = x;
            proxy.y = y;
            proxy.halfX = halfX;
            proxy.halfY = halfY;
            return proxy;
        }

        private function fill(proxies:Vector.<AgentProxy>):void
        {
            _bins.clear();
            for each (var proxy:AgentProxy in proxies)
            {
                _bins.fit(proxy);
                _bins.add(proxy);
            }
        }

        private function search(proxies:Vector.<AgentProxy>):void
        {
            fill(proxies);
            _sink.clear();
            _bins.findPairs(_sink);
        }

        // Whether some of the targets are reachable from the roots, through bins and lists.
        private static function reach(roots:Vector.<AgentProxy>, targets:Vector.<AgentProxy>):Boolean
        {
            var todo:Vector.<AgentProxy> = roots.concat();
            var seen:Dictionary = new Dictionary();
            while (todo.length > 0)
            {
                var proxy:AgentProxy = todo.pop();
                if (proxy == null || seen[proxy])
                {
                    continue;
                }
                seen[proxy] = true;
                if (targets.indexOf(proxy) >= 0)
                {
                    return true;
                }
                if (proxy.level != null)
                {
                    todo = todo.concat(proxy.level.proxies, proxy.level.previous);
                    for each (var head:BinEntry in proxy.level.heads)
                    {
                        todo.push(head == null ? null : head.proxy);
                    }
                }
                var entry:BinEntry = proxy.entry;
                for (var i:int = 0; i < 4; i++)
                {
                    todo.push(entry.next == null ? null : entry.next.proxy);
                    entry = entry.sibling;
                }
            }
            return false;
        }

        // How many overlap. A pair a hair's breadth apart may be found or not.
        private function assertLikeBruteForce(name:String, proxies:Vector.<AgentProxy>):int
        {
            search(proxies);
            assertEquals(name, _sink.length, _bins.pairCount);
            var overlapping:int = 0;
            for (var i:int = 0; i < proxies.length; i++)
            {
                for (var j:int = i + 1; j < proxies.length; j++)
                {
                    var a:AgentProxy = proxies[i];
                    var b:AgentProxy = proxies[j];
                    var gapX:Number = Math.abs(a.x - b.x) - a.halfX - b.halfX;
                    var gapY:Number = Math.abs(a.y - b.y) - a.halfY - b.halfY;
                    var found:int = _sink.count(a, b);
                    if (gapX <= 0 && gapY <= 0)
                    {
                        overlapping++;
                        assertEquals(name + ", " + i + " and " + j, 1, found);
                    }
                    else if (gapX > 1e-3 || gapY > 1e-3)
                    {
                        assertEquals(name + ", " + i + " and " + j, 0, found);
                    }
                }
            }
            return overlapping;
        }
    }
}

import starlogo.broadphase.AgentProxy;
import starlogo.broadphase.PairSink;

/** Notes the pairs. */
class PairList extends PairSink
{
    public var length:int = 0;

    private var _pairs:Object = {};

    override public function onCandidates(proxy:AgentProxy, others:Vector.<AgentProxy>, count:int):void
    {
        for (var i:int = 0; i < count; i++)
        {
            length++;
            var key:String = keyOf(proxy, others[i]);
            _pairs[key] = int(_pairs[key]) + 1;
        }
    }

    public function count(a:AgentProxy, b:AgentProxy):int
    {
        return _pairs[keyOf(a, b)];
    }

    public function clear():void
    {
        length = 0;
        _pairs = {};
    }

    private static function keyOf(a:AgentProxy, b:AgentProxy):String
    {
        return Math.min(a.agent.id, b.agent.id) + " " + Math.max(a.agent.id, b.agent.id);
    }
}
