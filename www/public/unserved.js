// Says why the page does not start. A classic script: browsers load no modules where the page has no origin.
if (self.origin === "null" && location.protocol !== "file:")
  for (const reason of document.querySelectorAll(".unserved"))
    reason.hidden = reason.dataset.reason !== "sandbox";
